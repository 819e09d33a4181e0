// SPDX-License-Identifier: MIT
#pragma once

#include "backends/spectra/pencil.h"
#include "complex/cell_complex.h"
#include "dec/stars/star.h"

namespace polydec {

/// The diagonal entries of a star, or its matrix.
Weights weights(const HodgeStar& star);

/// The pencil star_k Delta_k x = lambda star_k x on primal k-forms, in parts. The uncertainties
/// bound the rounding in computed diagonal stars (CellVolumes::rounding); points, and stars that
/// are matrices, count as exact. A relative error of the mass moves each eigenvalue by at most that
/// share. This holds for each part (Ostrowski 1959), and so for both, as their nonzero eigenvalues
/// are separate. Throws InvalidInput, naming the cells, if star_(k-1) has a zero.
Pencil laplacian_pencil(const CellComplex& complex, const HodgeStars& stars, int k);

/// The same for k = n and a diagonal star_n. The unknowns are star_n times the forms: dual
/// functions, which have exact differences. Throws like laplacian_pencil.
Pencil dual_function_pencil(const CellComplex& complex, const HodgeStars& stars, int n);

/// The pencil d_k^T star_(k+1) d_k x = lambda star_k x, k < n. Coexact forms have the same
/// eigenvalues as in laplacian_pencil; all other forms are in the kernel.
Pencil coexact_pencil(const CellComplex& complex, const HodgeStars& stars, int k);

} // namespace polydec
