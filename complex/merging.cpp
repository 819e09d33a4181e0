// SPDX-License-Identifier: MIT
#include "complex/merging.h"

#include "base/checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace polydec {

namespace {

using Row = IncidenceMatrix::InnerIterator;
using Carriers = std::vector<std::vector<Merging::Carrier>>;

/// Numbers the blocks of each degree in the order of their first pieces.
Carriers number_blocks(const SimplicialComplex& complex, const Blocks& blocks) {
    const int n = complex.dimension();
    std::vector<std::vector<Index>> number(n + 1);
    for (int k = 0; k <= n; ++k) {
        number[k].assign(complex.size(k), -1);
        Index next = 0;
        for (Index s = 0; s < complex.size(k); ++s) {
            const auto& carrier = blocks.carriers[k][s];
            if (carrier.dimension == k && carrier.piece == s)
                number[k][s] = next++;
        }
    }
    Carriers carriers(n + 1);
    for (int k = 0; k <= n; ++k)
        for (const auto& carrier : blocks.carriers[k])
            carriers[k].push_back({carrier.dimension, number[carrier.dimension][carrier.piece]});
    return carriers;
}

/// dia_k: the pieces of each cell are filled in by counting, so they come out ascending.
IncidenceMatrix make_diamond(const Carriers& carriers, const Blocks& blocks, int k) {
    const auto& own = carriers[k];
    Index cells = 0, pieces = 0;
    for (const auto& carrier : own)
        if (carrier.dimension == k) {
            cells = std::max(cells, carrier.cell + 1);
            ++pieces;
        }
    IncidenceMatrix diamond(cells, static_cast<Index>(own.size()));
    diamond.resizeNonZeros(pieces);
    Index* const begin = diamond.outerIndexPtr();
    for (const auto& carrier : own)
        if (carrier.dimension == k)
            ++begin[carrier.cell + 1];
    std::partial_sum(begin, begin + cells + 1, begin);
    std::vector<Index> next(begin, begin + cells);
    for (std::size_t s = 0; s < own.size(); ++s)
        if (own[s].dimension == k) {
            const Index place = next[own[s].cell]++;
            diamond.innerIndexPtr()[place] = static_cast<Index>(s);
            diamond.valuePtr()[place] = blocks.signs[k][s];
        }
    return diamond;
}

struct MergedDegree {
    IncidenceMatrix coboundary;
    std::vector<Index> coface_counts;
    std::vector<Incidence> canceled;
};

/// A cell in a boundary, with its sign.
struct Side {
    Index cell;
    int sign;
};

/// Sorted, with signs of equal cells added up and those that cancel moved out: a cell on both sides
/// of another. The sides of a single piece are sorted already, those of a few nearly so.
void add_up(std::vector<Side>& sides, Index cell, std::vector<Incidence>& canceled) {
    const auto comes_before = [](const Side& a, const Side& b) { return a.cell < b.cell; };
    if (!std::is_sorted(sides.begin(), sides.end(), comes_before))
        std::sort(sides.begin(), sides.end(), comes_before);
    std::size_t kept = 0;
    for (std::size_t i = 0, j = 0; i < sides.size(); i = j) {
        Side sum{sides[i].cell, 0};
        for (; j < sides.size() && sides[j].cell == sum.cell; ++j)
            sum.sign += sides[j].sign;
        if (sum.sign != 0)
            sides[kept++] = sum;
        else
            canceled.push_back({cell, sum.cell});
    }
    sides.resize(kept);
}

/// d^P_k. All pieces of a k-cell have the same merged cofaces, so its first piece tells: d^P(E, F)
/// is the sum over the pieces t of E around it of sign(t) [t : piece] sign(piece).
MergedDegree merge_degree(const SimplicialComplex& complex, const Blocks& blocks,
                          const Carriers& carriers, const std::vector<IncidenceMatrix>& diamonds,
                          int k) {
    const IncidenceMatrix& upper = diamonds[k + 1];
    const auto cells = static_cast<Index>(upper.rows());
    std::vector<Index> columns, ends{0};
    std::vector<std::int8_t> signs;
    ends.reserve(static_cast<std::size_t>(cells) + 1);
    columns.reserve(static_cast<std::size_t>(upper.nonZeros()) * 2);
    signs.reserve(columns.capacity());
    std::vector<Index> counts(diamonds[k].rows(), 0);
    std::vector<Incidence> canceled;
    std::vector<Side> sides;
    for (Index cell = 0; cell < cells; ++cell) {
        sides.clear();
        for (Row piece(upper, cell); piece; ++piece)
            for (Row s(complex.coboundary(k), piece.col()); s; ++s) {
                const auto& block = blocks.carriers[k][s.col()];
                if (block.dimension != k || block.piece != s.col())
                    continue;
                const Index face = carriers[k][s.col()].cell;
                ++counts[face];
                sides.push_back({face, piece.value() * s.value()});
            }
        add_up(sides, cell, canceled);
        for (const Side& side : sides) {
            columns.push_back(side.cell);
            signs.push_back(static_cast<std::int8_t>(side.sign));
        }
        ends.push_back(static_cast<Index>(columns.size()));
    }
    MergedDegree result{IncidenceMatrix(cells, diamonds[k].rows()), std::move(counts),
                        std::move(canceled)};
    result.coboundary.resizeNonZeros(static_cast<Index>(columns.size()));
    std::copy(columns.begin(), columns.end(), result.coboundary.innerIndexPtr());
    std::copy(signs.begin(), signs.end(), result.coboundary.valuePtr());
    std::copy(ends.begin(), ends.end(), result.coboundary.outerIndexPtr());
    return result;
}

CellComplex make_merged(const SimplicialComplex& complex, const Blocks& blocks,
                        const Carriers& carriers, const std::vector<IncidenceMatrix>& diamonds) {
    std::vector<IncidenceMatrix> coboundaries(complex.dimension());
    std::vector<std::vector<Index>> counts;
    std::vector<std::vector<Incidence>> canceled;
    for (int k = 0; k < complex.dimension(); ++k) {
        auto degree = merge_degree(complex, blocks, carriers, diamonds, k);
        coboundaries[k].swap(degree.coboundary);
        counts.push_back(std::move(degree.coface_counts));
        canceled.push_back(std::move(degree.canceled));
    }
    return {CellComplex::Unchecked{}, std::move(coboundaries), std::move(counts),
            std::move(canceled)};
}

std::vector<IncidenceMatrix> make_diamonds(const Carriers& carriers, const Blocks& blocks) {
    std::vector<IncidenceMatrix> diamonds(carriers.size());
    for (std::size_t k = 0; k < carriers.size(); ++k) {
        IncidenceMatrix diamond = make_diamond(carriers, blocks, static_cast<int>(k));
        diamonds[k].swap(diamond);
    }
    return diamonds;
}

} // namespace

Merging::Merging(SimplicialComplex input, const Blocks& blocks)
    : input_(std::move(input)),
      carriers_(number_blocks(input_, blocks)),
      diamonds_(make_diamonds(carriers_, blocks)),
      merged_(make_merged(input_, blocks, carriers_, diamonds_)) {}

std::vector<Index> Merging::vertices(int k, Index cell) const {
    const IncidenceMatrix& pieces = diamond(k);
    check_number(fmt::format("{}-cell", k), cell, 0, pieces.rows() - 1);
    std::vector<Index> list;
    for (Row s(pieces, cell); s; ++s) {
        const auto simplex = input_.simplices(k).row(s.col());
        list.insert(list.end(), simplex.begin(), simplex.end());
    }
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    return list;
}

Merging unmerged(SimplicialComplex complex) {
    const std::vector<bool> none(complex.size(complex.dimension() - 1), false);
    const auto blocks = join_blocks(complex, none, [](int, Index, Index, Index) { return false; });
    return {std::move(complex), blocks};
}

} // namespace polydec
