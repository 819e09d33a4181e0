// SPDX-License-Identifier: MIT
#pragma once

#include "complex/simplicial_complex.h"
#include "tests/support/counted.h"

#include <functional>

namespace polydec::test {

/// A k-form on R^N: at a point, its coefficients at dx_I for the k-subsets I of 0..N-1 in
/// lexicographic order.
using Form = std::function<Vector(const Vector& point)>;

/// The form with the same coefficients everywhere.
Form constant_form(Vector coefficients);

/// Number of coefficients of a k-form on R^N.
inline Index coefficients(Index N, int k) {
    return binomial(N, k);
}

/// Integrals over the k-simplices as they are oriented, exact for coefficients that are quadratic
/// polynomials.
Vector integrate(const SimplicialComplex& complex, const Points& points, int k, const Form& form);

/// The k-vector of each simplex, edge vectors wedged over k!: its products with a constant form are
/// the integrals of that form. One row per simplex; for k = 0 ones.
DenseMatrix multivectors(const SimplicialComplex& complex, const Points& points, int k);

} // namespace polydec::test
