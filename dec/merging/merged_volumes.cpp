// SPDX-License-Identifier: MIT
#include "dec/merging/merged_cells.h"

#include <utility>

namespace polydec {

namespace {

/// The volumes of cells, degree by degree.
struct Lists {
    std::vector<Vector> primal, dual, terms, rounding;

    /// sum_of(cell): of its pieces.
    template <class SumOf>
    void add_degree(Index cells, SumOf sum_of) {
        for (auto* values : {&primal, &dual, &terms, &rounding})
            values->emplace_back(cells);
        for (Index cell = 0; cell < cells; ++cell) {
            const PieceSum sum = sum_of(cell);
            primal.back()[cell] = sum.primal;
            dual.back()[cell] = sum.dual / sum.primal;
            terms.back()[cell] = sum.terms / sum.primal;
            rounding.back()[cell] = sum.rounding / sum.primal;
        }
    }

    CellVolumes volumes() && {
        return {std::move(primal), std::move(dual), std::move(terms), std::move(rounding)};
    }
};

} // namespace

CellVolumes volumes_of(const std::vector<std::vector<PieceSum>>& sums) {
    Lists lists;
    for (const auto& cells : sums)
        lists.add_degree(static_cast<Index>(cells.size()), [&](Index cell) { return cells[cell]; });
    return std::move(lists).volumes();
}

CellVolumes merged_volumes(std::span<const IncidenceMatrix> diamonds, const CellVolumes& input) {
    Lists lists;
    for (int k = 0; k < std::ssize(diamonds); ++k) {
        const Index *const begins = diamonds[k].outerIndexPtr(), *const pieces =
                                                                     diamonds[k].innerIndexPtr();
        const Vector &primal = input.primal(k), &dual = input.dual(k);
        const Bounds &terms = input.terms(k), &rounding = input.rounding(k);
        lists.add_degree(static_cast<Index>(diamonds[k].rows()), [&](Index cell) {
            PieceSum sum;
            for (Index i = begins[cell]; i < begins[cell + 1]; ++i) {
                const Index s = pieces[i];
                const double volume = primal[s];
                sum.add({volume, volume * dual[s], volume * terms[s], volume * rounding[s]});
            }
            return sum;
        });
    }
    return std::move(lists).volumes();
}

CellVolumes merged_volumes(const Merging& merging, const CellVolumes& input) {
    return merging.is_identity() ? input : merged_volumes(merging.diamonds(), input);
}

} // namespace polydec
