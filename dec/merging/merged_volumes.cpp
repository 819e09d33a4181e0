// SPDX-License-Identifier: MIT
#include "dec/merging/merged_volumes.h"

#include <utility>
#include <vector>

namespace polydec {

CellVolumes merged_volumes(std::span<const IncidenceMatrix> diamonds, const CellVolumes& input) {
    std::vector<Vector> primal, dual, terms, rounding;
    for (std::size_t k = 0; k < diamonds.size(); ++k) {
        const int degree = static_cast<int>(k);
        const SparseMatrix pieces = diamonds[k].cast<double>().cwiseAbs();
        const Vector& volumes = input.primal(degree);
        const auto mean = [&](const Vector& values) {
            const Vector products = pieces * volumes.cwiseProduct(values);
            return Vector(products.cwiseQuotient(primal[k]));
        };
        primal.emplace_back(pieces * volumes);
        dual.push_back(mean(input.dual(degree)));
        terms.push_back(mean(input.terms(degree).vector()));
        rounding.push_back(mean(input.rounding(degree).vector()));
    }
    return {std::move(primal), std::move(dual), std::move(terms), std::move(rounding)};
}

CellVolumes merged_volumes(const Merging& merging, const CellVolumes& input) {
    return merging.is_identity() ? input : merged_volumes(merging.diamonds(), input);
}

} // namespace polydec
