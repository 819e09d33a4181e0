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

namespace {

std::vector<Bounds> sizes_of(const std::vector<Vector>& dual) {
    std::vector<Bounds> terms;
    for (const Vector& values : dual)
        terms.emplace_back(values.cwiseAbs());
    return terms;
}

std::vector<Bounds> rounding_of_all(const std::vector<Bounds>& terms) {
    std::vector<Bounds> rounding;
    for (const Bounds& sizes : terms)
        rounding.emplace_back(sizes.vector().unaryExpr(&rounding_of));
    return rounding;
}

template <class To>
std::vector<To> moved(std::vector<Vector> values) {
    std::vector<To> result;
    for (Vector& of_degree : values)
        result.emplace_back(std::exchange(of_degree, {}));
    return result;
}

} // namespace

CellVolumes::CellVolumes(std::vector<Vector> primal, std::vector<Vector> dual,
                         std::vector<Vector> terms, std::vector<Vector> rounding) {
    auto sizes = terms.empty() ? sizes_of(dual) : moved<Bounds>(std::move(terms));
    auto lost = rounding.empty() ? rounding_of_all(sizes) : moved<Bounds>(std::move(rounding));
    *this = CellVolumes(moved<Values>(std::move(primal)), moved<Values>(std::move(dual)),
                        std::move(sizes), std::move(lost));
}

CellVolumes::CellVolumes(std::vector<Values> primal, std::vector<Values> dual,
                         std::vector<Bounds> terms, std::vector<Bounds> rounding) {
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
    const Values &primal = primals[k], &dual = duals[k];
    const Bounds &terms = all_terms[k], &rounding = roundings[k];
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
    const Values &primal = parts_->primal[checked(k)], &dual = parts_->dual[k];
    Vector result(size(k));
    for (Index s = 0; s < result.size(); ++s)
        result[s] = dual[s] / primal[s];
    return result;
}

CellVolumes CellVolumes::with_dual(int k, Vector dual) const {
    const Vector terms = dual.cwiseAbs();
    return with_dual(k, std::move(dual), terms, terms.unaryExpr(&rounding_of));
}

CellVolumes CellVolumes::with_dual(int k, Vector dual, Vector terms, Vector rounding) const {
    Parts parts = *parts_;
    parts.terms[checked(k)] = terms;
    parts.rounding[k] = rounding;
    parts.dual[k] = std::move(dual);
    CellVolumes result;
    result.parts_ = std::make_shared<Parts>(std::move(parts));
    result.check(k);
    return result;
}

CellVolumes CellVolumes::mapped(const Map& of) const {
    const int n = dimension();
    std::vector<Vector> primals, duals, all_terms, roundings;
    for (int k = 0; k <= n; ++k) {
        primals.push_back(of(k, k, primal(k)));
        duals.push_back(of(k, n - k, dual(k)));
        all_terms.push_back(of(k, n - k, terms(k).vector()));
        roundings.push_back(of(k, n - k, rounding(k).vector()));
    }
    return {std::move(primals), std::move(duals), std::move(all_terms), std::move(roundings)};
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
    if (parts_->primal.empty())
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
