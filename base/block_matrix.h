// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

namespace polydec {

/// [A B^T; B D], with A and D square and shapes that fit: symmetric if A and D are; entries of each
/// row are in order. Linear time.
SparseMatrix block_matrix(const SparseMatrix& A, const SparseMatrix& B, const SparseMatrix& D);

/// The square matrix with these numbers on its diagonal; any count, also 0.
SparseMatrix diagonal_matrix(const Vector& numbers);

} // namespace polydec
