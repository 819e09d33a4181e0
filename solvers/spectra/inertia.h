// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear_solver.h"

#include <memory>
#include <optional>
#include <string>

namespace polydec {

/// How far a symmetric matrix B may be from that which is meant.
struct Doubt {
    Vector sizes;        ///< at least |B_ij| <= sqrt(sizes_i sizes_j); what is added up in B_ii
    double share = 0;    ///< errors of B_ij / sqrt(sizes_i sizes_j): largest row sum
    double relative = 0; ///< share by which each eigenvalue may be off besides
};

/// Counts eigenvalues of a symmetric matrix below a shift, by the inertia of B - shift I. It is
/// that of D (B - shift I) D with any diagonal D > 0, which is chosen so that no entry is above 1:
/// on graded meshes the norm of B says nothing of the accuracy of its small entries.
class InertiaCounter {
public:
    /// B is shared; the engine must be one that counts.
    InertiaCounter(std::shared_ptr<const SparseMatrix> B, const std::string& engine,
                   int domain_dimension, Doubt doubt);
    ~InertiaCounter();

    /// The number of those meant that lie below the shift, if it can be trusted: what is in doubt,
    /// and by far the backward error of solves, must be below the smallest eigenvalue of the scaled
    /// matrix, as inverse iteration tells it, and what is in doubt relatively below `gap`, the
    /// distance of the shift from the nearest eigenvalue; nullopt if not, or if the factorization
    /// broke down.
    std::optional<Index> below(double shift, double gap);

    struct Counted {
        double shift;
        Index below;
    };

    /// A count that can be trusted at some place in the gap from `low` to `high`, below which at
    /// least so many eigenvalues are known; nullopt if there is none.
    std::optional<Counted> between(double low, double high, Index known);

    /// A shift in (low, high) with `done` eigenvalues below it, as low has, from which the next is
    /// not half as far as all but `wanted` others: iterations about it converge where those about
    /// low would not. Bisection, of lengths above `length` by their exponents.
    double shift_close_to(Index done, Index wanted, double low, double high, double length);

private:
    SparseMatrix scaled(double shift) const;

    std::shared_ptr<const SparseMatrix> B_;
    std::unique_ptr<LinearSolver> solver_;
    MatrixFacts facts_;
    Doubt doubt_;
};

/// B - shift I.
SparseMatrix shifted(const SparseMatrix& B, double shift);

/// A length on the axis below eigenvalues that are not zero, but not so small that a shift by it
/// is next to singular. On graded meshes the coarse cells decide.
double small_length(const SparseMatrix& B);

} // namespace polydec
