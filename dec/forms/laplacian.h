// SPDX-License-Identifier: MIT
#pragma once

#include "dec/forms/cells.h"
#include "dec/forms/operator.h"

namespace polydec {

// What these return acts on values as it is, and becomes a matrix where one is asked for.

/// Codifferential of primal k-forms, to (k-1)-forms: star_(k-1)^-1 d_(k-1)^T star_k, the adjoint of
/// d_(k-1) in the inner products of the stars. size(k-1) x size(k); units length^-2 times those of
/// d. Throws InvalidInput, naming the cells, if star_(k-1) has a zero.
Operator codifferential(const Cells& cells, int k);

/// Codifferential of dual j-forms, to dual (j-1)-forms: star d star^-1 up to the sign that makes it
/// the adjoint of the dual derivative; with k = n-j it maps k-cells to (k+1)-cells by
/// (-1)^(k+1) star_(k+1) d_k star_k^-1. Throws like the above if star_k has a zero.
Operator dual_codifferential(const Cells& cells, int j);

/// Laplace-de Rham operator on primal k-forms, d delta + delta d: positive semidefinite where the
/// stars are positive. size(k) x size(k); units length^-2. Nothing flows through the boundary: for
/// k = 0 Neumann's condition, for 0 < k < n the normal part is 0; the density of n-forms is 0 there
/// (Dirichlet). Throws InvalidInput, naming the cells, if star_(k-1), or star_k for k < n, has a
/// zero.
Operator laplacian(const Cells& cells, int k);

/// Laplace-de Rham operator on dual j-forms: star_k Delta_k star_k^-1 with k = n-j, on the k-cells.
/// Their values on the boundary are 0: for j = 0 Dirichlet's condition, for 0 < j < n the
/// tangential part is 0; nothing flows out of the density of n-forms (Neumann). Throws like
/// laplacian.
Operator dual_laplacian(const Cells& cells, int j);

/// star_k Delta_k = d_k^T star_(k+1) d_k + star_k d_(k-1) star_(k-1)^-1 d_(k-1)^T star_k:
/// symmetric, size(k) x size(k). Throws InvalidInput, naming the cells, if star_(k-1) has a zero.
Operator symmetric_laplacian(const Cells& cells, int k);

} // namespace polydec
