// SPDX-License-Identifier: MIT
#include "dec/metric/cell_volumes.h"

#include "base/checks.h"
#include "base/errors.h"
#include "complex/cell_complex.h"
#include "dec/metric/rounding.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

namespace polydec {

CellVolumes::CellVolumes(std::vector<Vector> primal, std::vector<Vector> dual) {
    check_as_many("degrees of dual volumes", std::ssize(dual), std::ssize(primal));
    std::vector<Degree> degrees;
    for (std::size_t k = 0; k < primal.size(); ++k) {
        const Bounds terms(dual[k].cwiseAbs());
        degrees.push_back({std::exchange(primal[k], {}), std::exchange(dual[k], {}), terms,
                           Vector(terms.vector().unaryExpr(&rounding_of))});
    }
    *this = CellVolumes(std::move(degrees));
}

CellVolumes::CellVolumes(std::vector<Degree> degrees)
    : parts_(std::make_shared<Parts>(Parts{std::move(degrees), {}})) {
    for (int k = 0; k <= dimension(); ++k)
        check(k);
}

void CellVolumes::check(int k) const {
    const auto& [primal, dual, terms, rounding] = degree(k);
    if (primal.size() != dual.size() || primal.size() != terms.size() ||
        primal.size() != rounding.size())
        throw InvalidInput(fmt::format("{} volumes, {} dual volumes, {} terms and {} rounding "
                                       "errors are given for the {}-cells: expected one of each "
                                       "for every cell",
                                       primal.size(), dual.size(), terms.size(), rounding.size(),
                                       k));
    constexpr double lowest = -std::numeric_limits<double>::infinity();
    if (primal.are_above(0) && dual.are_above(lowest) && terms.are_finite() &&
        rounding.are_finite())
        return;
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

Vector CellVolumes::ratios(int k) const {
    return degree(k).dual.numbers().cwiseQuotient(degree(k).primal.numbers());
}

CellVolumes CellVolumes::with_dual(int k, Vector dual) const {
    const Vector terms = dual.cwiseAbs();
    return with_dual(k, std::move(dual), terms, terms.unaryExpr(&rounding_of));
}

CellVolumes CellVolumes::with_dual(int k, Vector dual, Vector terms, Vector rounding) const {
    Parts parts = *parts_;
    parts.degrees[checked(k)] = {degree(k).primal, std::move(dual), terms, rounding};
    CellVolumes result;
    result.parts_ = std::make_shared<Parts>(std::move(parts));
    result.check(k);
    return result;
}

CellVolumes CellVolumes::mapped(const Map& of) const {
    const int n = dimension();
    std::vector<Degree> degrees;
    for (int k = 0; k <= n; ++k)
        degrees.push_back({of(k, primal(k)), of(k, dual(k)), of(k, terms(k).vector()),
                           of(k, rounding(k).vector())});
    return CellVolumes(std::move(degrees));
}

CellVolumes CellVolumes::numbered(std::vector<std::vector<Index>> numbers) const {
    check_as_many("degrees of numbers", static_cast<Index>(numbers.size()), dimension() + 1);
    for (int k = 0; k <= dimension(); ++k)
        check_as_many(fmt::format("numbers of {}-cells", k), static_cast<Index>(numbers[k].size()),
                      size(k));
    Parts parts = *parts_;
    parts.numbers = std::move(numbers);
    CellVolumes result;
    result.parts_ = std::make_shared<Parts>(std::move(parts));
    return result;
}

void CellVolumes::refuse_degree(int k) const {
    if (parts_->degrees.empty())
        throw InvalidInput(fmt::format("volumes of {}-cells do not exist: there are no cells", k));
    throw InvalidInput(fmt::format(
        "volumes of {}-cells do not exist: expected a degree from 0 to {}", k, dimension()));
}

void check_fit(const CellComplex& complex, const CellVolumes& volumes) {
    const int n = complex.dimension();
    check_as_many("degrees of volumes", volumes.dimension() + 1, n + 1);
    for (int k = 0; k <= n; ++k)
        check_as_many(fmt::format("volumes of {}-cells", k), volumes.size(k), complex.size(k));
}

} // namespace polydec
