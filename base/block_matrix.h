// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

namespace polydec {

/// [A B^T; B D], with A and D square and shapes that fit: symmetric if A and D are; entries of each
/// row are in order. Linear time.
SparseMatrix block_matrix(const SparseMatrix& A, const SparseMatrix& B, const SparseMatrix& D);

} // namespace polydec
