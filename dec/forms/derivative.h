// SPDX-License-Identifier: MIT
#pragma once

#include "complex/cell_complex.h"

namespace polydec {

/// Exterior derivative of primal k-forms: the coboundary d_k as a real matrix, size(k+1) x size(k).
/// Needs no metric; d_(k+1) d_k = 0 exactly. k = -1..n, with empty matrices at both ends.
SparseMatrix derivative(const CellComplex& complex, int k);

/// Exterior derivative of dual j-forms, which live on the (n-j)-cells, to dual (j+1)-forms:
/// (-1)^(k+1) d_k^T with k = n-j-1, size(k) x size(k+1).
SparseMatrix dual_derivative(const CellComplex& complex, int j);

} // namespace polydec
