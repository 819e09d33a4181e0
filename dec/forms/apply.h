// SPDX-License-Identifier: MIT
#pragma once

#include "complex/cell_complex.h"
#include "dec/metric/cell_volumes.h"

namespace polydec {

/// The operators as functions of a vector of values, without their matrices: what apply_x gives is
/// x(..) * values to rounding, in the time that reading the incidences takes. k and j as there.
/// Throw InvalidInput like the matrices, and if the number of values is not that of the cells.

/// derivative(complex, k) * x.
Vector apply_derivative(const CellComplex& complex, int k, const Vector& x);

/// derivative(complex, k).transpose() * y.
Vector apply_transposed_derivative(const CellComplex& complex, int k, const Vector& y);

/// codifferential(complex, volumes, k) * x.
Vector apply_codifferential(const CellComplex& complex, const CellVolumes& volumes, int k,
                            const Vector& x);

/// dual_codifferential(complex, volumes, j) * y.
Vector apply_dual_codifferential(const CellComplex& complex, const CellVolumes& volumes, int j,
                                 const Vector& y);

/// laplacian(complex, volumes, k) * x.
Vector apply_laplacian(const CellComplex& complex, const CellVolumes& volumes, int k,
                       const Vector& x);

/// symmetric_laplacian(complex, volumes, k) * x, and its diagonal: what solve_matrix_free() takes.
Vector apply_symmetric_laplacian(const CellComplex& complex, const CellVolumes& volumes, int k,
                                 const Vector& x);
Vector symmetric_laplacian_diagonal(const CellComplex& complex, const CellVolumes& volumes, int k);

/// dual_laplacian(complex, volumes, j) * y.
Vector apply_dual_laplacian(const CellComplex& complex, const CellVolumes& volumes, int j,
                            const Vector& y);

} // namespace polydec
