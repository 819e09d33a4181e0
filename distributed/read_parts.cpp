// SPDX-License-Identifier: MIT
#include "distributed/read_parts.h"

#include "base/errors.h"
#include "base/listed.h"
#include "distributed/number_places.h"
#include "io/meshes/mesh_layout.h"
#include "meshes/flat_cells.h"
#include "meshes/tidy.h"

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

using Corners = std::vector<GlobalIndex>;

Corners sorted_corners(const GlobalSimplices& cells, Eigen::Index cell) {
    Corners corners(cells.row(cell).begin(), cells.row(cell).end());
    std::sort(corners.begin(), corners.end());
    return corners;
}

/// Cells meet on the rank in whose slice their first vertex is.
void check_double_cells(const Ranks& ranks, const MeshSlice& slice) {
    const EqualStretches vertices(slice.vertices, ranks.size());
    auto parcels = ranks.empty_parcels<GlobalIndex>();
    ranks.together("double cells", [&] {
        for (Eigen::Index t = 0; t < slice.simplices.rows(); ++t) {
            const Corners corners = sorted_corners(slice.simplices, t);
            if (std::adjacent_find(corners.begin(), corners.end()) != corners.end())
                throw InvalidInput("some cells have a repeated corner");
            auto& parcel = parcels[vertices.rank_of(corners[0])];
            parcel.insert(parcel.end(), corners.begin(), corners.end());
        }
    });
    const auto arrived = ranks.deliver(std::move(parcels));
    ranks.together("double cells", [&] {
        const auto width = slice.simplices.cols();
        std::vector<const GlobalIndex*> cells;
        for (const auto& parcel : arrived)
            for (std::size_t at = 0; at < parcel.size(); at += static_cast<std::size_t>(width))
                cells.push_back(parcel.data() + at);
        std::sort(cells.begin(), cells.end(), [=](const GlobalIndex* a, const GlobalIndex* b) {
            return std::lexicographical_compare(a, a + width, b, b + width);
        });
        const auto is_same = [=](const GlobalIndex* a, const GlobalIndex* b) {
            return std::equal(a, a + width, b);
        };
        if (std::adjacent_find(cells.begin(), cells.end(), is_same) != cells.end())
            throw InvalidInput("some cells have the same vertices");
    });
}

/// Whether a cell is flat depends on its own vertices alone.
void check_flat_cells(const Ranks& ranks, const MeshSlice& slice, const NumberPlaces& here) {
    Mesh own;
    own.points = points_of(ranks, slice, here.numbers());
    ranks.together("flat cells", [&] {
        own.simplices = slice.simplices.unaryExpr([&](GlobalIndex vertex) { return here(vertex); });
        if (!flat_cells(own).empty())
            throw InvalidInput("some cells have no volume");
    });
}

/// Of the vertices of slices those that belong to no cell: how many, and the first ones.
void warn_of_isolated(const Ranks& ranks, MeshSlice& slice, const NumberPlaces& here) {
    const EqualStretches vertices(slice.vertices, ranks.size());
    const GlobalIndex first = vertices.begin(ranks.rank());
    auto parcels = ranks.empty_parcels<GlobalIndex>();
    ranks.together("vertices", [&] {
        for (const GlobalIndex vertex : here.numbers())
            parcels[vertices.rank_of(vertex)].push_back(vertex);
    });
    const auto arrived = ranks.deliver(std::move(parcels));
    std::vector<GlobalIndex> isolated;
    const GlobalIndex here_isolated = ranks.together("vertices", [&] {
        std::vector<bool> used(slice.points.rows(), false);
        for (const auto& parcel : arrived)
            for (const GlobalIndex vertex : parcel)
                used[vertex - first] = true;
        for (std::size_t v = 0; v < used.size() && isolated.size() < most_listed; ++v)
            if (!used[v])
                isolated.push_back(first + static_cast<GlobalIndex>(v));
        return GlobalIndex{std::count(used.begin(), used.end(), false)};
    });
    const GlobalIndex count = ranks.sum(here_isolated);
    isolated = ranks.of_all(isolated);
    if (count > 0 && ranks.rank() == 0)
        slice.warnings.push_back(isolated_vertices(isolated, static_cast<std::size_t>(count)));
}

MeshSlice slice_from(const Ranks& ranks, const MeshLayout& layout, const PartialFile& file) {
    MeshSlice slice{layout.points.count(), layout.cells.count(), {}, {}, {}, layout.has_tags};
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
    return slice;
}

} // namespace

bool is_tidy(const Ranks& ranks, MeshSlice& slice, std::string& why) {
    try {
        check_double_cells(ranks, slice);
        const NumberPlaces here = ranks.together("vertices", [&] {
            return NumberPlaces(
                {slice.simplices.data(), static_cast<std::size_t>(slice.simplices.size())});
        });
        check_flat_cells(ranks, slice, here);
        warn_of_isolated(ranks, slice, here);
        return true;
    } catch (const InvalidInput& error) {
        why = error.what();
        return false;
    }
}

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
