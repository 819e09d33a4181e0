// SPDX-License-Identifier: MIT
#pragma once

#include "shape/barycentric.h"
#include "shape/shape.h"

#include <optional>

namespace polydec {

/// One n-simplex of a shape, measured by its edge lengths.
struct MeasuredSimplex {
    LongMatrix squares;   ///< of the lengths between corners: (n+1) x (n+1)
    LongMatrix gradients; ///< inner products of the gradients of the barycentric coordinates
    long double volume;
    int origin;            ///< an end of the shortest edge
    double longest_square; ///< the square of the longest edge, and of the shortest
    double shortest_square;
    /// Largest relative change of squared lengths of vectors inside, over the relative error of all
    /// edge lengths: about 8 for well-shaped triangles, and 2 (h / height)^2.
    double sensitivity;

    int dimension() const { return static_cast<int>(squares.rows()) - 1; }
    long double facet_volume(int omitted) const;
};

/// Throws InvalidInput, naming the simplex, if no simplex has these lengths.
MeasuredSimplex measured_simplex(const Shape& shape, Index simplex);

/// The simplex with these squared lengths between corners, if there is one.
std::optional<MeasuredSimplex> measured_simplex(LongMatrix squares);

/// An upper bound on the squared constant C in Poincare's inequality |w| <= C |grad w|, over the
/// squared diameter, for w of mean 0 on a convex body of dimension n: 1 / pi^2, for triangles 1 /
/// j_(1,1)^2. Source: Payne, Weinberger 1960; Bebendorf 2003; Laugesen, Siudeja 2010.
double poincare_square(int n);

/// The largest relative error of squares of lengths within simplices. Throws InvalidInput, naming
/// the simplex, if it is too large to be a bound.
double metric_share(const Shape& shape);

/// The largest sensitivity.
double most_sensitivity(const Shape& shape);

/// A lower bound f of lambda' / lambda and of lambda / lambda', where lambda' is an eigenvalue for
/// the computed metric and lambda the same eigenvalue of the shape. For metrics that differ by a
/// share d at most, f = (1-d) ((1-d) / (1+d))^(n/2). Throws InvalidInput, naming the simplex, if d
/// is too large for a bound, and if lengths or weights are so far from 1 that bounds would overflow
/// or underflow.
double metric_ratio(const Shape& shape);

} // namespace polydec
