// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

namespace polydec {

/// The rounding error that a sum of terms of this size can have: four times its last digit, by
/// which coordinates, products and sums are off. On grids of boxes, hexagons, spheres and tori,
/// turned, moved by 1000 times their size and flattened to 1e-5, zeros were within .6 of it.
inline double rounding_of(double terms) {
    return 4 * std::numeric_limits<double>::epsilon() * terms;
}

/// Whether a sum is zero as far as can be told: no larger than the rounding error of its terms.
inline bool is_zero(double sum, double terms) {
    return std::abs(sum) <= rounding_of(terms);
}

} // namespace polydec
