// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

namespace polydec {

/// Area of the triangle with these side lengths, length^2; 0 if there is no such triangle. Accurate
/// to the last digits, also for needles. Source: Kahan, Miscalculating area and angles of a
/// needle-like triangle.
inline double triangle_area(double a, double b, double c) {
    const double larger = std::max(a, b), smaller = std::min(a, b), third = std::min(larger, c);
    a = std::max(larger, c);
    b = std::max(third, smaller);
    c = std::min(third, smaller);
    const double product = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
    return product > 0 ? std::sqrt(product) / 4 : 0;
}

/// Twice the scalar product of the sides b and c, from the corner opposite to side a, length^2: by
/// the law of cosines, whose difference with the most cancellation is computed as a product.
inline double twice_scalar_product(double a, double b, double c) {
    const double longer = std::max(b, c), shorter = std::min(b, c);
    return shorter * shorter + (longer - a) * (longer + a);
}

/// Cotangent of the angle opposite side a, between sides b and c, of a triangle of known area.
inline double corner_cotangent(double a, double b, double c, double area) {
    return twice_scalar_product(a, b, c) / (4 * area);
}

/// The angle itself, from 0 to pi.
inline double corner_angle(double a, double b, double c, double area) {
    return std::atan2(4 * area, twice_scalar_product(a, b, c));
}

} // namespace polydec
