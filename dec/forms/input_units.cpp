// SPDX-License-Identifier: MIT
#include "dec/forms/input_units.h"

#include <fmt/format.h>

namespace polydec {

CellVolumes in_input_units(const CellVolumes& volumes, double unit) {
    if (unit == 1)
        return volumes;
    const int n = volumes.dimension();
    std::vector<Vector> primal, dual, terms, rounding;
    for (int k = 0; k <= n; ++k) {
        const auto scaled = [&](const Vector& values, int power) {
            return in_input_units(values, unit, power, fmt::format("volumes of degree {}", k));
        };
        primal.push_back(scaled(volumes.primal(k), k));
        dual.push_back(scaled(volumes.dual(k), n - k));
        terms.push_back(scaled(volumes.terms(k).vector(), n - k));
        rounding.push_back(scaled(volumes.rounding(k).vector(), n - k));
    }
    return {std::move(primal), std::move(dual), std::move(terms), std::move(rounding)};
}

HodgeStars in_input_units(const HodgeStars& stars, double unit) {
    if (unit == 1)
        return stars;
    const int n = stars.dimension();
    HodgeStars result(in_input_units(stars.volumes(), unit));
    for (int k = 0; k <= n; ++k)
        if (const HodgeStar star = stars[k]; !star.is_diagonal())
            result = result.with(k, in_input_units(star.matrix(), unit, n - 2 * k,
                                                   fmt::format("the star of degree {}", k)));
    return result;
}

SparseMatrix in_input_units(SparseMatrix matrix, double unit, double power, std::string_view what) {
    if (unit == 1)
        return matrix;
    matrix.makeCompressed();
    matrix.coeffs() = in_input_units(Vector(matrix.coeffs()), unit, power, what).array();
    return matrix;
}

} // namespace polydec
