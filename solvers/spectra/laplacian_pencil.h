// SPDX-License-Identifier: MIT
#pragma once

#include "backends/spectra/pencil.h"
#include "complex/cell_complex.h"
#include "dec/forms/star.h"

namespace polydec {

/// The entries of its diagonal, or the matrix that it is.
Weights weights(const HodgeStar& star);

/// star_k Delta_k x = lambda star_k x on primal k-forms by its parts. Their uncertainties are what
/// computing has done at most to diagonal stars (CellVolumes::rounding); points, and stars that are
/// matrices, are taken as exact. An uncertain mass moves each eigenvalue by that share of it: true
/// of each part (Ostrowski 1959), and so of both, since they have their nonzero eigenvalues apart
/// from each other. Throws InvalidInput, naming the cells, if star_(k-1) has a zero.
Pencil laplacian_pencil(const CellComplex& complex, const HodgeStars& stars, int k);

/// The same for k = n and a diagonal star_n. Unknowns are star_n times the forms: the
/// dual functions, whose differences are exact. Throws like the above.
Pencil dual_function_pencil(const CellComplex& complex, const HodgeStars& stars, int n);

/// d_k^T star_(k+1) d_k x = lambda star_k x, k < n: coexact forms have the same eigenvalues as
/// above, all others are in its kernel.
Pencil coexact_pencil(const CellComplex& complex, const HodgeStars& stars, int k);

} // namespace polydec
