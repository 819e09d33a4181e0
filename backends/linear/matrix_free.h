// SPDX-License-Identifier: MIT
#pragma once

#include "backends/eigen_solver.h"
#include "backends/linear_solver.h"

namespace polydec {

/// x with A x = b by Eigen's conjugate gradients, for a positive semidefinite A that is given by
/// what it does alone: no matrix exists. diagonal: that of A, one positive number for each unknown,
/// by which the steps are scaled; empty: none. If A has a kernel, b must be orthogonal to it, and x
/// is so up to rounding. Of the options tolerance and max_iterations count; report, if given, says
/// how it went: engine "eigen.cg", iterations, the true residual |b - A x| / |b|.
/// Throws InvalidInput for sizes that do not fit, numbers that are not finite, or a diagonal that
/// is not positive; SolverFailure if the iteration ends without reaching the tolerance, or ten
/// times as much in the true residual. Errors that A.apply() throws pass through.
Vector solve_matrix_free(const SymmetricOperator& A, const Vector& b, const Vector& diagonal = {},
                         const LinearSolverOptions& options = {}, SolveReport* report = nullptr);

} // namespace polydec
