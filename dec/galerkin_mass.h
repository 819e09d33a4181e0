// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"

namespace polydec {

/// What a symmetric matrix of the k-simplices of the pieces, size(k) x size(k), is for the forms on
/// cells: by the lift.
SparseMatrix lifted(const Discretization& mesh, int k, const SparseMatrix& of_pieces);

/// Inner products of Whitney k-forms on the cells, by the lift, each n-cell's times its weight, at
/// least 0: size(k) x size(k), units length^(n-2k). Flat pieces, whose forms have no bound, have no
/// part in it. Source: Whitney 1957.
SparseMatrix galerkin_mass(const Discretization& mesh, int k, const Vector& weights);

} // namespace polydec
