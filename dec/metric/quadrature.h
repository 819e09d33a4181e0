// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

namespace polydec {

/// Points and weights of a quadrature rule on a k-simplex: the integral of f is approximately the
/// volume times the sum of weights[q] f(point q).
struct SimplexQuadrature {
    DenseMatrix points; ///< one row of k+1 barycentric coordinates per point
    Vector weights;     ///< sum 1; some are negative
};

/// The rule of Grundmann and Moeller on a simplex of any dimension k >= 0, exact for polynomials up
/// to the given degree, rounded up to the next odd degree 2s+1. It has (s+k+1 over k+1) points, all
/// inside the simplex. The sum of absolute weights grows with the degree, so degrees beyond about
/// 15 lose digits.
/// Source: Grundmann, Moeller 1978, Theorem 4. Throws InvalidInput if k or degree is negative.
SimplexQuadrature grundmann_moeller(int k, int degree);

} // namespace polydec
