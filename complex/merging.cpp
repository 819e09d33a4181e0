// SPDX-License-Identifier: MIT
#include "complex/merging.h"

#include <algorithm>
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

/// Rows are filled by counting: entry (row(i), i) = sign(i) for all i with row(i) >= 0.
template <class RowOf, class SignOf>
IncidenceMatrix one_entry_per_column(Index rows, Index columns, RowOf row, SignOf sign) {
    IncidenceMatrix transposed(columns, rows);
    transposed.reserve(Eigen::VectorXi::Constant(columns, 1));
    for (Index i = 0; i < columns; ++i)
        if (row(i) >= 0)
            transposed.insert(i, row(i)) = sign(i);
    transposed.makeCompressed();
    return transposed.transpose();
}

IncidenceMatrix make_diamond(const Carriers& carriers, const Blocks& blocks, int k) {
    const auto& own = carriers[k];
    const auto row = [&](Index s) { return own[s].dimension == k ? own[s].cell : -1; };
    Index cells = 0;
    for (const auto& carrier : own)
        if (carrier.dimension == k)
            cells = std::max(cells, carrier.cell + 1);
    return one_entry_per_column(cells, static_cast<Index>(own.size()), row,
                                [&](Index s) { return blocks.signs[k][s]; });
}

struct MergedDegree {
    IncidenceMatrix coboundary;
    std::vector<Index> coface_counts;
};

/// d^P_k. All pieces of a k-cell have the same merged cofaces, so its first piece tells: d^P(E, F)
/// is the sum over the pieces t of E around it of sign(t) [t : piece] sign(piece).
MergedDegree merge_degree(const SimplicialComplex& complex, const Blocks& blocks,
                          const Carriers& carriers, const IncidenceMatrix& diamond,
                          Index upper_cells, int k) {
    const auto lower_cells = static_cast<Index>(diamond.rows());
    std::vector<Eigen::Triplet<std::int8_t, Index>> entries;
    MergedDegree result{IncidenceMatrix(upper_cells, lower_cells),
                        std::vector<Index>(lower_cells, 0)};
    for (Index t = 0; t < complex.size(k + 1); ++t) {
        if (carriers[k + 1][t].dimension != k + 1)
            continue;
        for (Row s(complex.coboundary(k), t); s; ++s) {
            const auto& block = blocks.carriers[k][s.col()];
            if (block.dimension != k || block.piece != s.col())
                continue;
            const Index cell = carriers[k][s.col()].cell;
            ++result.coface_counts[cell];
            entries.emplace_back(carriers[k + 1][t].cell, cell,
                                 static_cast<std::int8_t>(blocks.signs[k + 1][t] * s.value()));
        }
    }
    result.coboundary.setFromTriplets(entries.begin(), entries.end());
    // a cell on both sides of F cancels
    result.coboundary.prune([](Index, Index, std::int8_t value) { return value != 0; });
    return result;
}

CellComplex make_merged(const SimplicialComplex& complex, const Blocks& blocks,
                        const Carriers& carriers, const std::vector<IncidenceMatrix>& diamonds) {
    std::vector<IncidenceMatrix> coboundaries;
    std::vector<std::vector<Index>> counts;
    for (int k = 0; k < complex.dimension(); ++k) {
        auto degree = merge_degree(complex, blocks, carriers, diamonds[k],
                                   static_cast<Index>(diamonds[k + 1].rows()), k);
        coboundaries.push_back(std::move(degree.coboundary));
        counts.push_back(std::move(degree.coface_counts));
    }
    return {CellComplex::Unchecked{}, std::move(coboundaries), std::move(counts)};
}

std::vector<IncidenceMatrix> make_diamonds(const Carriers& carriers, const Blocks& blocks) {
    std::vector<IncidenceMatrix> diamonds;
    for (std::size_t k = 0; k < carriers.size(); ++k)
        diamonds.push_back(make_diamond(carriers, blocks, static_cast<int>(k)));
    return diamonds;
}

} // namespace

Merging::Merging(SimplicialComplex input, const Blocks& blocks)
    : input_(std::move(input)),
      carriers_(number_blocks(input_, blocks)),
      diamonds_(make_diamonds(carriers_, blocks)),
      merged_(make_merged(input_, blocks, carriers_, diamonds_)) {}

std::vector<Index> Merging::vertices(int k, Index cell) const {
    std::vector<Index> list;
    for (Row s(diamond(k), cell); s; ++s) {
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
