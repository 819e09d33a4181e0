// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear_solver.h"
#include "backends/spectra/certified_eigensolver.h"
#include "shape/forms.h"
#include "shape/shape_spectrum.h"

#include <memory>
#include <optional>

namespace polydec {

/// Approximate eigenfunctions among conforming functions.
struct RitzPairs {
    DenseMatrix vectors; ///< columns, of norm 1 in b
    Vector upper;        ///< ascending bounds of as many eigenvalues of a and b (Rayleigh, Ritz)
};

/// Bounds of the smallest eigenvalues of exact forms K x = lambda M x, as many as columns of X, in
/// spite of rounding: the largest Rayleigh quotient of the first j + 1 columns, for each j. They
/// are close if X^T K X is nearly diagonal and X^T M X nearly the identity; else large or infinite.
Vector rayleigh_ritz_bounds(const CountedMatrix& K, const CountedMatrix& M, const DenseMatrix& X);

/// The entry behind the largest gap between ascending values, of those from `first` on; the size if
/// there is none.
Index largest_gap(const Vector& values, Index first);

/// Finds Ritz pairs in a block Krylov space that starts with the eigenvectors of linear functions
/// with lumped masses: one step takes away most of what these have of large eigenvalues. On coarse
/// symmetric meshes it may miss pairs of other symmetry than these; bounds hold nevertheless.
class RitzSolver {
public:
    /// The first `zeros` eigenvalues are 0. What is given must outlive this.
    RitzSolver(const Shape& shape, const ConformingForm& form, Index zeros,
               const ShapeSpectrumOptions& options);

    /// The `count` smallest, at most as many as there are functions and at least `zeros`, and some
    /// behind them that are less accurate. Throws SolverFailure if a + shift b
    /// cannot be factorized.
    RitzPairs smallest(Index count);

private:
    DenseMatrix start(Index count);

    const ConformingForm& form_;
    ConformingForm linear_;
    Index zeros_;
    const ShapeSpectrumOptions& options_;
    CountedMatrix K_, M_; // in units that make the diagonal of M about 1, K less 2^exponent
    Vector units_;
    int exponent_;
    std::optional<CertifiedEigensolver> start_; // none: no linear function
    double shift_;                              // K + shift M is factorized
    MatrixFacts facts_;
    std::unique_ptr<LinearSolver> solver_;
};

} // namespace polydec
