// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <memory>

namespace polydec {

/// The sparse factor R in M = R^T R of a symmetric positive definite matrix, with fill-reducing
/// column order.
class CholeskyRoot {
public:
    /// Throws InvalidInput if M is not positive definite; SolverFailure if the number of entries of
    /// R overflows.
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
