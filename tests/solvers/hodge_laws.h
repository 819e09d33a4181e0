// SPDX-License-Identifier: MIT
#pragma once

#include "dec/forms/side.h"
#include "dec/forms/star.h"

namespace polydec::test {

/// On any cells, by any positive star of k-cells: parts of forms of both sides add up, are
/// orthogonal, and have their potentials.
void expect_orthogonal_parts(const CellComplex& complex, const HodgeStars& stars, int k);

/// Harmonic forms are as many as Betti numbers say, orthonormal, closed, coclosed, and stay.
void expect_harmonic_forms(const CellComplex& complex, const HodgeStars& stars, int k);

/// Exact forms have no other part, nor have coexact ones.
void expect_parts_stay(const CellComplex& complex, const HodgeStars& stars, int k);

} // namespace polydec::test
