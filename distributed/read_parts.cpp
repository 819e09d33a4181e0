// SPDX-License-Identifier: MIT
#include "distributed/read_parts.h"

#include "base/errors.h"
#include "distributed/number_places.h"
#include "distributed/tidy_slice.h"
#include "io/meshes/mesh_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace polydec {

namespace {

/// The part that this rank reads of a table.
DenseMatrix own_rows(const Ranks& ranks, const RecordTable& table, const PartialFile& file,
                     std::endian order) {
    const EqualStretches stretches(table.count(), ranks.size());
    return rows_of(table, file, order, stretches.begin(ranks.rank()), stretches.end(ranks.rank()));
}

Points own_points(const Ranks& ranks, const MeshLayout& layout, const PartialFile& file) {
    Points points = own_rows(ranks, layout.points, file, layout.order);
    if (!points.allFinite())
        refuse_layout(file, "a vertex has a coordinate that is not finite");
    return points;
}

/// Vertices as the file calls them. A double holds whole numbers up to 2^53.
GlobalSimplices whole_numbers(const DenseMatrix& numbers, const PartialFile& file) {
    GlobalSimplices result(numbers.rows(), numbers.cols());
    for (Eigen::Index i = 0; i < numbers.rows(); ++i)
        for (Eigen::Index j = 0; j < numbers.cols(); ++j) {
            const double number = numbers(i, j);
            if (!(std::abs(number) < 0x1p53) || number != std::floor(number))
                refuse_layout(file, "the number of a vertex is not a whole number");
            result(i, j) = static_cast<GlobalIndex>(number);
        }
    return result;
}

void check_expected(const Ranks& ranks, const MeshLayout& layout, const PartialFile& file) {
    for (const auto& [table, first, step] : layout.expected) {
        const GlobalIndex begin = EqualStretches(table.count(), ranks.size()).begin(ranks.rank());
        const DenseMatrix own = own_rows(ranks, table, file, layout.order);
        for (Eigen::Index i = 0; i < own.rows(); ++i)
            if (own(i, 0) != first + step * static_cast<double>(begin + i))
                refuse_layout(file, "not all cells are simplices of one kind");
    }
}

/// The vertices that nodes of other numbers are, in the order of the file.
class NodeNumbers {
public:
    NodeNumbers(const Ranks& ranks, const MeshLayout& layout, const PartialFile& file)
        : ranks_(ranks), file_(file), count_(layout.points.count()) {
        if (!layout.nodes)
            return;
        const GlobalIndex begin = EqualStretches(count_, ranks.size()).begin(ranks.rank());
        const GlobalSimplices own = ranks.together("nodes", [&] {
            return whole_numbers(own_rows(ranks, *layout.nodes, file, layout.order), file);
        });
        first_ = ranks.sum(ranks.rank() == 0 ? own(0, 0) : 0);
        bool is_elsewhere = false;
        for (Eigen::Index i = 0; i < own.rows(); ++i)
            is_elsewhere = is_elsewhere || own(i, 0) != first_ + begin + i;
        has_gaps_ = ranks.any(is_elsewhere);
        if (has_gaps_)
            gather(own, begin);
    }

    /// Collective. Throws InvalidInput where there is no such node.
    void rename(GlobalSimplices& cells) const {
        if (has_gaps_)
            return look_up(cells);
        ranks_.together("vertices", [&] {
            cells.array() -= first_;
            for (const GlobalIndex vertex : cells.reshaped())
                if (vertex < 0 || vertex >= count_)
                    refuse_layout(file_, "a cell has a vertex that does not exist");
        });
    }

private:
    using Node = std::array<GlobalIndex, 2>; // number, vertex

    int rank_of(GlobalIndex number) const {
        return static_cast<int>(static_cast<std::uint64_t>(number) %
                                static_cast<std::uint64_t>(ranks_.size()));
    }

    void gather(const GlobalSimplices& own, GlobalIndex begin) {
        auto parcels = ranks_.empty_parcels<Node>();
        ranks_.together("nodes", [&] {
            for (Eigen::Index i = 0; i < own.rows(); ++i)
                parcels[rank_of(own(i, 0))].push_back({own(i, 0), begin + i});
        });
        const auto arrived = ranks_.deliver(std::move(parcels));
        ranks_.together("nodes", [&] {
            nodes_ = unpacked(arrived);
            std::sort(nodes_.begin(), nodes_.end());
            const auto is_same = [](const Node& a, const Node& b) { return a[0] == b[0]; };
            if (std::adjacent_find(nodes_.begin(), nodes_.end(), is_same) != nodes_.end())
                refuse_layout(file_, "two nodes have the same number");
        });
    }

    GlobalIndex vertex_of(GlobalIndex number) const {
        const auto found = std::lower_bound(nodes_.begin(), nodes_.end(), Node{number, 0});
        if (found == nodes_.end() || (*found)[0] != number)
            refuse_layout(file_, "a cell has a node that does not exist");
        return (*found)[1];
    }

    void look_up(GlobalSimplices& cells) const {
        std::vector<int> whom;
        const NumberPlaces here = ranks_.together("nodes", [&] {
            NumberPlaces places({cells.data(), static_cast<std::size_t>(cells.size())});
            for (const GlobalIndex number : places.numbers())
                whom.push_back(rank_of(number));
            return places;
        });
        const auto vertices = ranks_.ask<GlobalIndex>(
            "nodes", whom, here.numbers(), [&](GlobalIndex number) { return vertex_of(number); });
        for (GlobalIndex& vertex : cells.reshaped())
            vertex = vertices[here(vertex)];
    }

    const Ranks& ranks_;
    const PartialFile& file_;
    GlobalIndex count_;
    GlobalIndex first_ = 0; // where numbers have no gaps
    bool has_gaps_ = false;
    std::vector<Node> nodes_; // of this rank, ascending
};

MeshSlice slice_from(const Ranks& ranks, const MeshLayout& layout, const PartialFile& file) {
    MeshSlice slice{layout.points.count(), layout.cells.count(), {}, {}};
    slice.points = ranks.together("points", [&] { return own_points(ranks, layout, file); });
    ranks.together("read", [&] { check_expected(ranks, layout, file); });
    const NodeNumbers numbers(ranks, layout, file);
    const auto read_cells = [&](const RecordTable& table) {
        GlobalSimplices cells = ranks.together("cells", [&] {
            return whole_numbers(own_rows(ranks, table, file, layout.order), file);
        });
        numbers.rename(cells);
        return cells;
    };
    slice.simplices = read_cells(layout.cells);
    for (const RecordTable& others : layout.others)
        read_cells(others);
    if (ranks.rank() == 0)
        slice.warnings = layout.warnings;
    check_tidy(ranks, slice);
    return slice;
}

} // namespace

std::optional<MeshSlice> read_parts(const Ranks& ranks, const PartialFile& file, std::string& why) {
    try {
        const auto layout = ranks.together("read", [&] { return mesh_layout(file); });
        if (ranks.any(!layout))
            return std::nullopt;
        return slice_from(ranks, *layout, file);
    } catch (const InvalidInput& error) {
        why = error.what();
        return std::nullopt;
    }
}

} // namespace polydec
