// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

namespace polydec {

/// A diag(weights) A^T for an incidence matrix A and its transpose, rows ascending: the half of a
/// Laplacian. One pass over the incidences to count, one to fill; no product of sparse matrices.
SparseMatrix gram(const IncidenceMatrix& A, const IncidenceMatrix& transposed,
                  const Vector& weights);

} // namespace polydec
