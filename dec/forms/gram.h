// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

namespace polydec {

/// A diag(weights) A^T for an incidence matrix A and its transpose, rows ascending: the half of a
/// Laplacian. One pass over the incidences to make room, one to fill; no product of sparse
/// matrices.
SparseMatrix gram(const IncidenceMatrix& A, const IncidenceMatrix& transposed,
                  const Vector& weights);

/// A + B, of the same shape: a row after the other, where Eigen moves what it has written whenever
/// that has to grow.
SparseMatrix sum_of(const SparseMatrix& A, const SparseMatrix& B);

} // namespace polydec
