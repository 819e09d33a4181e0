// SPDX-License-Identifier: MIT
#include "dec/forms/input_units.h"

#include <fmt/format.h>

namespace polydec {

CellVolumes in_input_units(const CellVolumes& volumes, double unit) {
    if (unit == 1)
        return volumes;
    return volumes.mapped([&](int k, int power, const Vector& numbers) {
        return in_input_units(numbers, unit, power, fmt::format("volumes of degree {}", k));
    });
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
