// SPDX-License-Identifier: MIT
#include "dec/merging/merged_cells.h"

#include <utility>

namespace polydec {

namespace {

/// sum_of(cell): of its pieces.
template <class SumOf>
CellVolumes::Degree volumes_from(Index cells, SumOf sum_of) {
    Vector primal(cells), dual(cells), terms(cells), rounding(cells);
    for (Index cell = 0; cell < cells; ++cell) {
        const PieceSum sum = sum_of(cell);
        primal[cell] = sum.primal;
        dual[cell] = sum.dual / sum.primal;
        terms[cell] = sum.terms / sum.primal;
        rounding[cell] = sum.rounding / sum.primal;
    }
    return {std::move(primal), std::move(dual), terms, rounding};
}

} // namespace

CellVolumes volumes_of(const std::vector<std::vector<PieceSum>>& sums) {
    std::vector<CellVolumes::Degree> degrees;
    for (const auto& cells : sums)
        degrees.push_back(volumes_from(static_cast<Index>(cells.size()),
                                       [&](Index cell) { return cells[cell]; }));
    return CellVolumes(std::move(degrees));
}

CellVolumes merged_volumes(std::span<const IncidenceMatrix> diamonds, const CellVolumes& input) {
    std::vector<CellVolumes::Degree> degrees;
    for (int k = 0; k < std::ssize(diamonds); ++k) {
        const Index* const begins = diamonds[k].outerIndexPtr();
        const Index* const pieces = diamonds[k].innerIndexPtr();
        const CellVolumes::Degree& of_pieces = input.degree(k);
        degrees.push_back(volumes_from(static_cast<Index>(diamonds[k].rows()), [&](Index cell) {
            PieceSum sum;
            for (Index i = begins[cell]; i < begins[cell + 1]; ++i)
                sum.add(of_pieces, pieces[i]);
            return sum;
        }));
    }
    return CellVolumes(std::move(degrees));
}

CellVolumes merged_volumes(const Merging& merging, const CellVolumes& input) {
    return merging.is_identity() ? input : merged_volumes(merging.diamonds(), input);
}

} // namespace polydec
