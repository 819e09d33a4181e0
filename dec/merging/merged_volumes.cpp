// SPDX-License-Identifier: MIT
#include "dec/merging/merged_volumes.h"

#include <utility>
#include <vector>

namespace polydec {

CellVolumes volumes_of(const std::vector<std::vector<PieceSum>>& sums) {
    std::vector<Vector> primal, dual, terms, rounding;
    for (const auto& cells : sums) {
        const auto size = static_cast<Eigen::Index>(cells.size());
        for (auto* values : {&primal, &dual, &terms, &rounding})
            values->emplace_back(size);
        for (Eigen::Index cell = 0; cell < size; ++cell) {
            const PieceSum& sum = cells[static_cast<std::size_t>(cell)];
            primal.back()[cell] = sum.primal;
            dual.back()[cell] = sum.dual / sum.primal;
            terms.back()[cell] = sum.terms / sum.primal;
            rounding.back()[cell] = sum.rounding / sum.primal;
        }
    }
    return {std::move(primal), std::move(dual), std::move(terms), std::move(rounding)};
}

CellVolumes merged_volumes(std::span<const IncidenceMatrix> diamonds, const CellVolumes& input) {
    std::vector<std::vector<PieceSum>> sums;
    for (std::size_t k = 0; k < diamonds.size(); ++k) {
        auto& cells = sums.emplace_back(static_cast<std::size_t>(diamonds[k].rows()));
        for (Index cell = 0; cell < diamonds[k].rows(); ++cell)
            for (IncidenceMatrix::InnerIterator piece(diamonds[k], cell); piece; ++piece)
                cells[cell].add(input, static_cast<int>(k), static_cast<Index>(piece.col()));
    }
    return volumes_of(sums);
}

CellVolumes merged_volumes(const Merging& merging, const CellVolumes& input) {
    return merging.is_identity() ? input : merged_volumes(merging.diamonds(), input);
}

} // namespace polydec
