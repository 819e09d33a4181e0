// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear_solver.h"

#include <memory>
#include <string>

namespace polydec {

/// Solves M x + D^T c = f and D x = g: of all x with D x = g, x minimizes x^T M x / 2 - f^T x. M is
/// symmetric positive definite and need not be diagonal; then D M^-1 D^T, the matrix of c alone, is
/// dense. The rows of D may be dependent, and c is determined up to the kernel of D^T.
///
/// The matrix of both equations is indefinite, so a factorization without pivoting may meet zero
/// pivots. With a small negative diagonal block below M it is quasi-definite and meets none in any
/// order. A few steps of refinement (the method of multipliers) recover the solution of the
/// original equations. Where they shrink too slowly, on thin cells, generalized conjugate residuals
/// combine them.
///
/// With a symmetric semidefinite C, the second equation is D x - C c = g, and M may be
/// semidefinite: it then gets a small diagonal as well. Rounding determines the parts of x and c in
/// the kernel of all three matrices; data must have no such part. Source: Vanderbei 1995
/// (quasi-definite); Friedlander, Orban 2012 (refinement); Eisenstat, Elman, Schultz
/// 1983 (conjugate residuals). Use an object from one thread at a time.
class SaddleSolver {
public:
    /// Throws InvalidInput if negative eigenvalues of M are detected. Passes on the engine's
    /// errors.
    SaddleSolver(const SparseMatrix& M, const SparseMatrix& D, const std::string& engine,
                 int domain_dimension);
    SaddleSolver(const SparseMatrix& M, const SparseMatrix& D, const SparseMatrix& C,
                 const std::string& engine, int domain_dimension);

    struct Values {
        Vector x, c;
        SolveReport report;
    };

    /// `terms` are the magnitudes of the terms summed in f, then in g; by default |f| and |g|. Data
    /// and residuals at rounding level relative to them count as 0. Throws SolverFailure if there
    /// is no such x, because g is not in the range of D, and if corrections stay above 1e-7 of the
    /// solution.
    Values solve(const Vector& f, const Vector& g, const Vector& terms = {}) const;

private:
    SaddleSolver(Vector scales, const SparseMatrix& M, const SparseMatrix& D, const SparseMatrix& C,
                 double above, const std::string& engine, int domain_dimension);

    Vector accelerated(Vector step, double enough) const;

    Vector scales_;  // of rows and columns, so that diagonals are 1
    SparseMatrix A_; // with these scales, without the small diagonals
    Index size_;     // of x
    std::unique_ptr<LinearSolver> solver_;
};

} // namespace polydec
