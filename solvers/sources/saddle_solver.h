// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear_solver.h"

#include <memory>
#include <string>

namespace polydec {

/// x and c with M x + D^T c = f and D x = g: of all x with D x = g the one whose x^T M x / 2 - f^T
/// x is least. M is symmetric positive definite and need not be diagonal, so that D M^-1 D^T, which
/// c alone would obey, is dense; the rows of D may depend on each other, and c is determined up to
/// what D^T takes to 0.
///
/// The matrix of both is indefinite, and a factorization that does not exchange rows may meet zeros
/// in it. With a small negative diagonal below M it meets none in any order (it is quasi-definite),
/// and a few steps of refinement, the method of multipliers, lead back to the equations as they
/// are.
///
/// With a C, symmetric and semidefinite, the second equation is D x - C c = g, and M need be no
/// more than semidefinite: then it gets a small diagonal as well. Parts of x and c that all three
/// take to 0 are whatever rounding makes of them, and data must not have them. Source: Vanderbei
/// 1995 (quasi-definite); Friedlander, Orban 2012 (refinement). An object is used by one thread at
/// a time.
class SaddleSolver {
public:
    /// Throws InvalidInput if M is seen to have negative eigenvalues; what the engine throws where
    /// it fails.
    SaddleSolver(const SparseMatrix& M, const SparseMatrix& D, const std::string& engine,
                 int domain_dimension);
    SaddleSolver(const SparseMatrix& M, const SparseMatrix& D, const SparseMatrix& C,
                 const std::string& engine, int domain_dimension);

    struct Values {
        Vector x, c;
        SolveReport report;
    };

    /// `terms` are the sizes of what f, and g behind it, are sums of, by default their own: what is
    /// rounding beside them counts as 0. Throws SolverFailure if there is no such x: for a g that D
    /// does not give.
    Values solve(const Vector& f, const Vector& g, const Vector& terms = {}) const;

    int domain_dimension() const { return domain_dimension_; }

private:
    SaddleSolver(Vector scales, const SparseMatrix& M, const SparseMatrix& D, const SparseMatrix& C,
                 double above, const std::string& engine, int domain_dimension);

    Vector scales_;  // by which rows and columns are multiplied, so that diagonals are 1
    SparseMatrix A_; // so scaled, without the small diagonals
    Index size_;     // of x
    int domain_dimension_;
    std::unique_ptr<LinearSolver> solver_;
};

} // namespace polydec
