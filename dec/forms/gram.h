// SPDX-License-Identifier: MIT
#pragma once

#include "complex/incidences.h"

namespace polydec {

/// D diag(weights) D^T, and D^T diag(weights) D, for the matrix D of incidences: the halves of a
/// Laplacian. One pass over the incidences to allocate, one to fill; no product of sparse matrices.
SparseMatrix gram_of_rows(const Incidences& D, const Vector& weights);
SparseMatrix gram_of_columns(const Incidences& D, const Vector& weights);

/// A + B, of the same shape, row by row. Eigen instead moves all written entries whenever its
/// storage has to grow.
SparseMatrix sum_of(const SparseMatrix& A, const SparseMatrix& B);

} // namespace polydec
