// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear_solver.h"

#include <memory>
#include <optional>
#include <string>

namespace polydec {

/// Counts eigenvalues of a symmetric matrix below a shift, by the inertia of B - shift I.
class InertiaCounter {
public:
    /// B is shared; the engine must be one that counts.
    InertiaCounter(std::shared_ptr<const SparseMatrix> B, const std::string& engine,
                   int domain_dimension);
    ~InertiaCounter();

    /// The number of eigenvalues below the shift, if the factorization can be trusted: the backward
    /// error of a solve, relative to the norm of B, must be far below `gap`, the distance of the
    /// shift from the nearest eigenvalue; nullopt if not, or if it broke down.
    std::optional<Index> below(double shift, double gap);

private:
    std::shared_ptr<const SparseMatrix> B_;
    std::unique_ptr<LinearSolver> solver_;
    MatrixFacts facts_;
    double norm_;
};

/// B - shift I.
SparseMatrix shifted(const SparseMatrix& B, double shift);

/// Largest row sum of absolute values: no eigenvalue of symmetric B is larger in size.
double row_sum_norm(const SparseMatrix& B);

} // namespace polydec
