// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <memory>

namespace polydec {

/// R with M = R^T R, of a symmetric positive definite matrix: sparse, with its columns in an order
/// that keeps it so.
class CholeskyRoot {
public:
    /// Throws InvalidInput if M is not positive definite; SolverFailure if R has more entries than
    /// can be counted.
    explicit CholeskyRoot(const SparseMatrix& M);
    ~CholeskyRoot();

    /// R X, R^-1 X, R^T X and R^-T X.
    DenseMatrix times(const DenseMatrix& X) const;
    DenseMatrix inverse_times(const DenseMatrix& X) const;
    DenseMatrix transposed_times(const DenseMatrix& X) const;
    DenseMatrix inverse_transposed_times(const DenseMatrix& X) const;

    /// M^-1 b.
    Vector solve(const Vector& b) const;

private:
    struct Factor; // P M P^T = L L^T, R = L^T P
    std::unique_ptr<const Factor> factor_;
};

} // namespace polydec
