// SPDX-License-Identifier: MIT
#include "dec/metric/cell_volumes.h"

#include "base/checks.h"
#include "base/errors.h"
#include "complex/cell_complex.h"
#include "dec/metric/rounding.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace polydec {

CellVolumes::CellVolumes(std::vector<Vector> primal, std::vector<Vector> dual,
                         std::vector<Vector> terms, std::vector<Vector> rounding) {
    if (terms.empty())
        for (const Vector& values : dual)
            terms.emplace_back(values.cwiseAbs());
    if (rounding.empty())
        for (const Vector& values : terms)
            rounding.emplace_back(values.unaryExpr(&rounding_of));
    if (primal.size() != dual.size() || primal.size() != terms.size() ||
        primal.size() != rounding.size())
        throw InvalidInput(fmt::format("volumes are given in {} degrees, dual volumes in {}, their "
                                       "terms in {} and rounding errors in {}: expected the same "
                                       "number",
                                       primal.size(), dual.size(), terms.size(), rounding.size()));
    parts_ = std::make_shared<Parts>(
        Parts{std::move(primal), std::move(dual), std::move(terms), std::move(rounding), {}});
    for (int k = 0; k <= dimension(); ++k)
        check(k);
}

void CellVolumes::check(int k) const {
    const auto& [primals, duals, all_terms, roundings, numbers] = *parts_;
    const Vector &primal = primals[k], &dual = duals[k];
    const Vector &terms = all_terms[k], &rounding = roundings[k];
    if (primal.size() != dual.size() || primal.size() != terms.size() ||
        primal.size() != rounding.size())
        throw InvalidInput(fmt::format("{} volumes, {} dual volumes, {} terms and {} rounding "
                                       "errors are given for the {}-cells: expected one of each "
                                       "for every cell",
                                       primal.size(), dual.size(), terms.size(), rounding.size(),
                                       k));
    for (Index s = 0; s < primal.size(); ++s) {
        if (!(primal[s] > 0) || !std::isfinite(primal[s]))
            throw InvalidInput(fmt::format("the {}-cell {} has volume {}: expected a finite number "
                                           "above 0; remove the cell",
                                           k, s, primal[s]),
                               {.degree = k, .cells = {s}});
        if (!std::isfinite(dual[s]) || !std::isfinite(terms[s]) || !std::isfinite(rounding[s]))
            throw InvalidInput(fmt::format("the {}-cell {} has dual volume {}, a sum of terms of "
                                           "size {}, to within {}: expected finite numbers",
                                           k, s, dual[s], terms[s], rounding[s]),
                               {.degree = k, .cells = {s}});
    }
}

CellVolumes CellVolumes::with_dual(int k, Vector dual) const {
    Parts parts = *parts_;
    parts.terms[checked(k)] = dual.cwiseAbs();
    parts.rounding[k] = parts.terms[k].unaryExpr(&rounding_of);
    parts.dual[k] = std::move(dual);
    CellVolumes result;
    result.parts_ = std::make_shared<Parts>(std::move(parts));
    result.check(k);
    return result;
}

CellVolumes CellVolumes::numbered(std::vector<std::vector<Index>> numbers) const {
    check_as_many("degrees of numbers", static_cast<Index>(numbers.size()), dimension() + 1);
    for (int k = 0; k <= dimension(); ++k)
        check_as_many(fmt::format("numbers of {}-cells", k), static_cast<Index>(numbers[k].size()),
                      primal(k).size());
    Parts parts = *parts_;
    parts.numbers = std::move(numbers);
    CellVolumes result;
    result.parts_ = std::make_shared<Parts>(std::move(parts));
    return result;
}

void CellVolumes::refuse_degree(int k) const {
    if (parts_->primal.empty())
        throw InvalidInput(fmt::format("volumes of {}-cells are asked for: there are no cells", k));
    throw InvalidInput(fmt::format("volumes of {}-cells are asked for: there are cells of degrees "
                                   "0 to {}",
                                   k, dimension()));
}

void check_fit(const CellComplex& complex, const CellVolumes& volumes) {
    const int n = complex.dimension();
    check_as_many("degrees of volumes", volumes.dimension() + 1, n + 1);
    for (int k = 0; k <= n; ++k) {
        check_as_many(fmt::format("volumes of {}-cells", k), volumes.primal(k).size(),
                      complex.size(k));
    }
}

} // namespace polydec
