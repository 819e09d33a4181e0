// SPDX-License-Identifier: MIT
#pragma once

#include "dec/forms/cells.h"
#include "dec/forms/operator.h"

namespace polydec {

// These operators act on values without a matrix, and convert to a matrix where one is needed. Both
// throw InvalidInput if results in the units of the input overflow or underflow.

/// Codifferential of primal k-forms, to (k-1)-forms: star_(k-1)^-1 d_(k-1)^T star_k, the adjoint of
/// d_(k-1) in the inner products of the stars. size(k-1) x size(k); units length^-2 times the units
/// of d. Throws InvalidInput, naming the cells, if star_(k-1) has a zero.
Operator codifferential(const Cells& cells, int k);

/// Codifferential of dual j-forms, to dual (j-1)-forms: star d star^-1, with the sign that makes it
/// the adjoint of the dual derivative. With k = n-j it maps k-cells to (k+1)-cells by (-1)^(k+1)
/// star_(k+1) d_k star_k^-1. Throws like codifferential if star_k has a zero.
Operator dual_codifferential(const Cells& cells, int j);

/// Laplace-de Rham operator on primal k-forms, d delta + delta d: positive semidefinite if the
/// stars are positive. size(k) x size(k); units length^-2. Nothing flows through the boundary: for
/// k = 0 Neumann's condition; for 0 < k < n the normal part is 0; for k = n the density is 0 there
/// (Dirichlet). Throws InvalidInput, naming the cells, if star_(k-1), or star_k for k < n, has a
/// zero.
Operator laplacian(const Cells& cells, int k);

/// Laplace-de Rham operator on dual j-forms: star_k Delta_k star_k^-1 with k = n-j, on the k-cells.
/// Boundary values are 0: for j = 0 Dirichlet's condition; for 0 < j < n the tangential part is 0;
/// for j = n nothing flows out of the density (Neumann). Throws like laplacian.
Operator dual_laplacian(const Cells& cells, int j);

/// star_k Delta_k = d_k^T star_(k+1) d_k + star_k d_(k-1) star_(k-1)^-1 d_(k-1)^T star_k:
/// symmetric, size(k) x size(k); units length^(n-2k-2). Throws InvalidInput, naming the cells, if
/// star_(k-1) has a zero.
Operator symmetric_laplacian(const Cells& cells, int k);

} // namespace polydec
