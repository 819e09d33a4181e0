// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

namespace polydec {

/// Area of the triangle with these side lengths, length^2; 0 if no triangle has them. Right to the
/// last digits for needles too. Source: Kahan, Miscalculating area and angles of a needle-like
/// triangle.
inline double triangle_area(double a, double b, double c) {
    if (a < b)
        std::swap(a, b);
    if (b < c)
        std::swap(b, c);
    if (a < b)
        std::swap(a, b);
    const double product = (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
    return product > 0 ? std::sqrt(product) / 4 : 0;
}

/// Cotangent of the angle between sides b and c of a triangle, opposite to a, of known area.
inline double corner_cotangent(double a, double b, double c, double area) {
    return (c * c + (b - a) * (b + a)) / (4 * area);
}

/// The angle itself, from 0 to pi.
inline double corner_angle(double a, double b, double c, double area) {
    return std::atan2(4 * area, c * c + (b - a) * (b + a));
}

/// Circumradius of a triangle of known area.
inline double triangle_circumradius(double a, double b, double c, double area) {
    return a * b * c / (4 * area);
}

/// How far relative errors of the lengths can move the circumcenter towards a side, for errors of
/// size 1: 3 R^2 / A times the longest side. An angle moves by 3 longest / (height on its side).
inline double triangle_height_terms(double a, double b, double c, double area) {
    const double radius = triangle_circumradius(a, b, c, area);
    return 3 * radius * radius * std::max({a, b, c}) / area;
}

/// How far relative errors of the lengths can change its area relatively, for errors of size 1: at
/// most R (a + b + c) / A.
inline double triangle_area_terms(double a, double b, double c, double area) {
    return 1 + triangle_circumradius(a, b, c, area) * (a + b + c) / area;
}

} // namespace polydec
