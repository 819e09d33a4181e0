// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>

namespace polydec {

/// Bound on the rounding error of a sum of terms of this size: four units in the last place, since
/// coordinates, products and sums are each rounded. On grids of boxes, hexagons, spheres and tori,
/// rotated, moved by 1000 times their size and flattened to 1e-5, zeros were within .6 of it.
inline double rounding_of(double terms) {
    return 4 * std::numeric_limits<double>::epsilon() * terms;
}

/// Whether a sum is zero up to rounding: at most the rounding error of its terms.
inline bool is_zero(double sum, double terms) {
    return std::abs(sum) <= rounding_of(terms);
}

} // namespace polydec
