// SPDX-License-Identifier: MIT
#pragma once

#include "tests/support/test.h"

namespace polydec::test {

/// A cochain with random values, the same for the same seed.
Cochain random_form(const CellComplex& complex, Side side, int degree, unsigned seed);

/// Coefficients of the exterior product of a constant k-form and a constant l-form on R^N.
Vector exterior_product(Index N, int k, const Vector& a, int l, const Vector& b);

/// Coefficients of the contraction i_x a of a constant k-form on R^N, k >= 1, with a vector.
Vector contraction(const Vector& x, int k, const Vector& a);

} // namespace polydec::test
