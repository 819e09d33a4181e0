// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

namespace polydec {

/// Largest row sum of absolute values, the norm of A that belongs to the maximum norm of vectors:
/// no eigenvalue of A is larger in size.
double row_sum_norm(const SparseMatrix& A);

} // namespace polydec
