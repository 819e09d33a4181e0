// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

namespace polydec {

/// Largest row sum of absolute values, the norm of A induced by the maximum norm of vectors: a
/// bound on the absolute value of every eigenvalue.
double row_sum_norm(const SparseMatrix& A);

} // namespace polydec
