// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear_solver.h"

#include <string>
#include <vector>

namespace polydec {

/// The engines that suit a matrix, best first, among those in this program. Symmetric and definite,
/// or semidefinite with known kernel: cholmod, eigen.ldlt, eigen.lu, eigen.cg; in three and more
/// dimensions, above a size where factors exceed memory, or where the diagonal dominates as in
/// short time steps, eigen.cg first and no LU. Semidefinite without known kernel: eigen.cg, which
/// needs none, then the others. Indefinite: L D L^T, then LU. General: eigen.lu, eigen.bicgstab. If
/// inertia is wanted: only engines that count.
std::vector<std::string> suitable_engines(const SparseMatrix& A, const MatrixFacts& facts);

/// A warning that names better engines for this matrix that are not installed, if the difference
/// takes seconds, and says how to get CHOLMOD, or the best of them; else empty.
std::string missed_engines(const SparseMatrix& A, const MatrixFacts& facts);

/// The warning of missed_engines() for the first matrix of the program for which `auto` missed an
/// engine. Returned once; empty before and afterwards.
std::string take_missed_engines();

} // namespace polydec
