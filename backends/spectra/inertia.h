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

/// The symmetric matrices A - shift M, for all shifts. Eigenvalues of a symmetric matrix B may be
/// asked of a larger one that is sparse where B is not: B - shift I is what remains of the last
/// rows where the first `hidden` ones, a negative definite block without shift, are eliminated. The
/// larger one has as many more negative eigenvalues (Haynsworth 1968).
struct ShiftedMatrices {
    std::shared_ptr<const SparseMatrix> A;
    SparseMatrix M; ///< positive semidefinite
    Index hidden = 0;

    /// B - shift I itself.
    ShiftedMatrices(std::shared_ptr<const SparseMatrix> B);
    ShiftedMatrices(SparseMatrix A, SparseMatrix M, Index hidden);

    SparseMatrix at(double shift) const { return *A - shift * M; }
};

/// Counts eigenvalues of a symmetric matrix below a shift, by the inertia of A - shift M. It is
/// that of D (A - shift M) D with any diagonal D > 0, which is chosen so that no entry is above 1:
/// on graded meshes the norm of A says nothing of the accuracy of its small entries.
class InertiaCounter {
public:
    /// The doubt is of A. The engine must be one that counts.
    InertiaCounter(ShiftedMatrices matrices, const std::string& engine, int domain_dimension,
                   Doubt doubt);
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

    ShiftedMatrices matrices_;
    std::unique_ptr<LinearSolver> solver_;
    MatrixFacts facts_;
    Doubt doubt_;
};

/// A length on the axis below eigenvalues that are not zero, but not so small that a shift by it
/// is next to singular. On graded meshes the coarse cells decide.
double small_length(const SparseMatrix& B);

} // namespace polydec
