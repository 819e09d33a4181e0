// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

namespace polydec {

/// [A B^T; B D], of A and D square and shapes that fit: symmetric if A and D are, the entries of
/// each row in order. In linear time.
SparseMatrix block_matrix(const SparseMatrix& A, const SparseMatrix& B, const SparseMatrix& D);

} // namespace polydec
