// SPDX-License-Identifier: MIT
#include "distributed/cell_numbers.h"

#include "base/lists.h"
#include "dec/merging/merge.h"
#include "dec/merging/merged_cells.h"
#include "distributed/in_order.h"
#include "distributed/number_places.h"
#include "distributed/piece_rows.h"

#include <algorithm>
#include <limits>

namespace polydec {

namespace {

/// By which its owner knows a cell. Rows ascend with these.
struct FirstPiece {
    int owner;
    GlobalIndex number;
    auto operator<=>(const FirstPiece&) const = default;
};

class Numbering {
public:
    Numbering(const Ranks& ranks, const LocalComplex& local, const DistributedMerging& merged,
              int k)
        : ranks_(ranks), local_(local), merged_(merged), k_(k) {}

    DistributedCells::Degree run() {
        const auto& degree = local_.degree(k_);
        std::vector<GlobalIndex> numbers; // of first pieces
        for (Index s = 0; s < degree.size(); ++s)
            if (local_.owns(ranks_, k_, s) && merged_.is_first_piece(local_, k_, s)) {
                cells_.first.push_back(s);
                numbers.push_back(degree.number[s]);
            }
        auto ordered = places_in_order(ranks_, numbers, 1, degree.count);
        cells_.count = ordered.count;
        cells_.number = std::move(ordered.places);
        cells_.first_row = ranks_.sum_before(cells_.own());
        find_others();
        find_cells();
        return std::move(cells_);
    }

private:
    const Carrier& carrier(Index s) const { return merged_.carriers[k_][s]; }
    bool is_piece(Index s) const { return carrier(s).dimension == k_; }

    void find_others();
    void find_cells();

    const Ranks& ranks_;
    const LocalComplex& local_;
    const DistributedMerging& merged_;
    int k_;
    DistributedCells::Degree cells_;
    std::vector<FirstPiece> others_; // first pieces of cells of others, ascending
};

/// Asks the owners of cells that begin elsewhere.
void Numbering::find_others() {
    const auto& degree = local_.degree(k_);
    for (Index s = 0; s < degree.size(); ++s)
        if (is_piece(s) && carrier(s).owner != ranks_.rank())
            others_.push_back({carrier(s).owner, carrier(s).first});
    sort_unique(others_);

    std::vector<int> whom;
    std::vector<GlobalIndex> firsts;
    for (const auto& [owner, number] : others_) {
        whom.push_back(owner);
        firsts.push_back(number);
    }
    cells_.others = ranks_.ask<CellNumber>("cell numbers", whom, firsts, [&](GlobalIndex number) {
        return cells_.cell(place_in(cells_.first, degree.find(number)));
    });
}

/// Of all pieces here. First pieces that are own come before the others of their cells.
void Numbering::find_cells() {
    const auto& degree = local_.degree(k_);
    const NumberPlaces place(degree.number);
    cells_.of_simplex.assign(degree.size(), -1);
    for (Index cell = 0; cell < cells_.own(); ++cell)
        cells_.of_simplex[cells_.first[cell]] = cell;
    for (Index s = 0; s < degree.size(); ++s)
        if (is_piece(s)) {
            const auto& [dimension, sign, owner, first] = carrier(s);
            cells_.of_simplex[s] = owner == ranks_.rank()
                                       ? cells_.of_simplex[place(first)]
                                       : cells_.own() + place_in(others_, {owner, first});
        }
}

/// Added up in ascending order of pieces, wherever these are.
std::vector<PieceSum> sums_of_volumes(const Ranks& ranks, const LocalComplex& local,
                                      const CellVolumes& of_pieces,
                                      const DistributedCells::Degree& cells, int k) {
    std::vector<PieceSum> sums(cells.own());
    OwnPieces(ranks, local, cells, k)
        .visit<PieceSum>(
            1,
            [&](Index s, PieceSum* piece) {
                *piece = {};
                piece->add(of_pieces.degree(k), s);
            },
            [&](Index cell, const PieceSum* piece) { sums[cell].add(*piece); });
    return sums;
}

/// Of simplices that are cells as they are.
CellVolumes own_volumes(const CellVolumes& all,
                        const std::vector<DistributedCells::Degree>& cells) {
    return all.mapped(
        [&](int k, const Vector& numbers) -> Vector { return numbers(cells[k].first); });
}

/// By which messages name cells; none if they do not fit.
std::vector<std::vector<Index>> numbers_of(const std::vector<DistributedCells::Degree>& cells) {
    std::vector<std::vector<Index>> numbers;
    for (const auto& degree : cells) {
        if (degree.count > std::numeric_limits<Index>::max())
            return {};
        numbers.emplace_back(degree.number.begin(), degree.number.end());
    }
    return numbers;
}

/// The first piece tells: all pieces of a cell have the same merged cofaces.
void add_cofaces(const LocalComplex& local, const DistributedMerging& merged,
                 const DistributedCells::Degree& above, int k, DistributedCells::Degree& cells) {
    struct Coface {
        GlobalIndex row;
        Index cell;
        int sign;
    };
    const Cofaces cofaces(local.complex, k + 1);
    std::vector<Coface> around;
    cells.begins.reserve(cells.first.size() + 1);
    for (const Index s : cells.first) {
        around.clear();
        for (const auto& [t, omitted] : cofaces.of(s))
            if (const Index cell = above.of_simplex[t]; cell >= 0)
                around.push_back(
                    {above.cell(cell).row, cell,
                     merged.carriers[k + 1][t].sign * local.complex.sign(k + 1, t, omitted)});
        std::sort(around.begin(), around.end(),
                  [](const Coface& x, const Coface& y) { return x.row < y.row; });
        for (auto entry = around.begin(); entry != around.end();) {
            const Index cell = entry->cell;
            int sign = 0;
            for (; entry != around.end() && entry->cell == cell; ++entry)
                sign += entry->sign;
            if (sign != 0) {
                cells.cofaces.push_back(cell);
                cells.signs.push_back(static_cast<std::int8_t>(sign));
            }
        }
        cells.begins.push_back(static_cast<Index>(cells.cofaces.size()));
    }
}

/// Collective.
void omit_duals_beyond_the_boundary(const Ranks& ranks, const LocalComplex& local,
                                    const DistributedMerging& merged, DistributedCells& cells) {
    if (merged.degenerate_boundary == 0)
        return;
    const int facets = cells.dimension() - 1;
    const auto& own = cells.degree(facets);
    Points others(local.complex.size(facets), 1);
    for (Index f = 0; f < others.rows(); ++f)
        others(f, 0) = merged.degenerate[f] ? 0 : 1;
    const Points sums = add_pieces(ranks, local, own, facets, others);
    std::vector<Index> cofaces;
    std::vector<bool> degenerate;
    for (std::size_t i = 0; i < own.first.size(); ++i) {
        cofaces.push_back(local.complex.coface_counts(facets)[own.first[i]]);
        degenerate.push_back(sums(static_cast<Index>(i), 0) == 0);
    }
    cells.volumes = without_duals_beyond_the_boundary(cells.volumes, cofaces,
                                                      [&](Index f) { return degenerate[f]; });
}

} // namespace

DistributedCells distributed_cells(const Ranks& ranks, const LocalComplex& local,
                                   const DistributedMerging& merged) {
    const int n = local.dimension();
    DistributedCells result;
    std::vector<std::vector<PieceSum>> sums;
    for (int k = 0; k <= n; ++k) {
        result.degrees.push_back(Numbering(ranks, local, merged, k).run());
        if (!merged.is_identity)
            sums.push_back(
                sums_of_volumes(ranks, local, merged.of_pieces, result.degrees.back(), k));
    }
    ranks.together("cells", [&] {
        for (int k = 0; k < n; ++k)
            add_cofaces(local, merged, result.degrees[k + 1], k, result.degrees[k]);
        result.volumes =
            merged.is_identity ? own_volumes(merged.of_pieces, result.degrees) : volumes_of(sums);
    });
    omit_duals_beyond_the_boundary(ranks, local, merged, result);
    ranks.together("cells", [&] {
        if (const auto numbers = numbers_of(result.degrees); !numbers.empty())
            result.volumes = result.volumes.numbered(numbers);
    });
    return result;
}

} // namespace polydec
