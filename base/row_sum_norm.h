// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

namespace polydec {

/// Largest row sum of absolute values, the norm of A induced by the maximum norm of vectors: a
/// bound on the absolute value of every eigenvalue.
double row_sum_norm(const SparseMatrix& A);

/// Largest absolute value of an entry; 0 if there is none. The matrix is compressed.
double largest_entry(const SparseMatrix& A);

} // namespace polydec
