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
                         std::vector<Vector> terms, std::vector<Vector> rounding)
    : primal_(std::move(primal)),
      dual_(std::move(dual)),
      terms_(std::move(terms)),
      rounding_(std::move(rounding)) {
    if (terms_.empty())
        for (const Vector& values : dual_)
            terms_.emplace_back(values.cwiseAbs());
    if (rounding_.empty())
        for (const Vector& values : terms_)
            rounding_.emplace_back(values.unaryExpr(&rounding_of));
    if (primal_.size() != dual_.size() || primal_.size() != terms_.size() ||
        primal_.size() != rounding_.size())
        throw InvalidInput(fmt::format("volumes are given in {} degrees, dual volumes in {}, their "
                                       "terms in {} and rounding errors in {}: expected the same "
                                       "number",
                                       primal_.size(), dual_.size(), terms_.size(),
                                       rounding_.size()));
    for (int k = 0; k <= dimension(); ++k)
        check(k);
}

void CellVolumes::check(int k) const {
    const Vector &primal = primal_[k], &dual = dual_[k], &terms = terms_[k];
    const Vector& rounding = rounding_[k];
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
                                           k, s, primal[s]));
        if (!std::isfinite(dual[s]) || !std::isfinite(terms[s]) || !std::isfinite(rounding[s]))
            throw InvalidInput(fmt::format("the {}-cell {} has dual volume {}, a sum of terms of "
                                           "size {}, to within {}: expected finite numbers",
                                           k, s, dual[s], terms[s], rounding[s]));
    }
}

CellVolumes CellVolumes::with_dual(int k, Vector dual) const {
    auto duals = dual_, terms = terms_, rounding = rounding_;
    terms[checked(k)] = dual.cwiseAbs();
    rounding[checked(k)] = terms[k].unaryExpr(&rounding_of);
    duals[checked(k)] = std::move(dual);
    CellVolumes result(primal_, std::move(duals), std::move(terms), std::move(rounding));
    result.numbers_ = numbers_;
    return result;
}

CellVolumes CellVolumes::numbered(std::vector<std::vector<Index>> numbers) const {
    check_as_many("degrees of numbers", static_cast<Index>(numbers.size()), dimension() + 1);
    for (int k = 0; k <= dimension(); ++k)
        check_as_many(fmt::format("numbers of {}-cells", k), static_cast<Index>(numbers[k].size()),
                      primal_[k].size());
    CellVolumes result = *this;
    result.numbers_ = std::move(numbers);
    return result;
}

void CellVolumes::refuse_degree(int k) const {
    if (primal_.empty())
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
