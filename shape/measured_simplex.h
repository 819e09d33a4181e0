// SPDX-License-Identifier: MIT
#pragma once

#include "shape/barycentric.h"
#include "shape/shape.h"

namespace polydec {

/// One n-simplex of a shape, by the lengths of its edges.
struct MeasuredSimplex {
    LongMatrix squares;   ///< of the lengths between corners: (n+1) x (n+1)
    LongMatrix gradients; ///< products of the gradients of the barycentric coordinates
    long double volume;
    int origin;            ///< an end of the shortest edge
    double longest_square; ///< the square of the longest edge
    /// How much an error of all lengths by a share e of them changes squares of lengths of vectors
    /// in it at most, as a multiple of e: about 8 for well-shaped triangles, and 2 (h / height)^2.
    double sensitivity;

    int dimension() const { return static_cast<int>(squares.rows()) - 1; }
    long double facet_volume(int omitted) const;
};

/// Throws InvalidInput, naming the simplex, if there is none with these lengths.
MeasuredSimplex measured_simplex(const Shape& shape, Index simplex);

/// The constant of Poincare's inequality |w| <= C |grad w| on a convex body of dimension n, for w
/// of mean 0: its square over that of the diameter, from above: 1 / pi^2, for triangles 1 /
/// j_(1,1)^2. Source: Payne, Weinberger 1960; Bebendorf 2003; Laugesen, Siudeja 2010.
double poincare_square(int n);

/// The share by which squares of lengths within simplices may be off, of the worst. Throws
/// InvalidInput, naming the simplex, where that says nothing.
double metric_share(const Shape& shape);

/// The most of sensitivity.
double most_sensitivity(const Shape& shape);

/// A lower bound f of lambda' / lambda and of lambda / lambda', lambda' an eigenvalue by the
/// numbers that are computed with and lambda the same of the shape: for metrics that differ by a
/// share d of them at most, f = (1-d) ((1-d) / (1+d))^(n/2). Throws InvalidInput, naming the
/// simplex, where that says nothing.
double metric_ratio(const Shape& shape);

} // namespace polydec
