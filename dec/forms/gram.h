// SPDX-License-Identifier: MIT
#pragma once

#include "complex/cell_complex.h"

namespace polydec {

/// D diag(weights) D^T, and D^T diag(weights) D with D = d_k, for the matrix D of incidences: the
/// halves of a Laplacian, without entries -0. One pass over the incidences to allocate, one to
/// fill; for the edges of a simplicial complex one in all. No product of sparse matrices.
SparseMatrix gram_of_rows(const Incidences& D, const Vector& weights);
SparseMatrix gram_of_columns(const CellComplex& complex, int k, const Vector& weights);

/// A + B, of the same shape, row by row. Eigen instead moves all written entries whenever its
/// storage has to grow.
SparseMatrix sum_of(const SparseMatrix& A, const SparseMatrix& B);

} // namespace polydec
