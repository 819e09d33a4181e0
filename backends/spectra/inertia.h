// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear_solver.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace polydec {

/// Error bounds of a symmetric matrix B relative to the exact one.
struct Doubt {
    Vector sizes;        ///< |B_ij| <= sqrt(sizes_i sizes_j); magnitudes of the terms in B_ii
    double share = 0;    ///< errors of B_ij / sqrt(sizes_i sizes_j): largest row sum
    double relative = 0; ///< additional relative error of each eigenvalue
};

/// The symmetric matrices A - shift M, for all shifts: B - shift I themselves with M = I. If a
/// symmetric matrix B is not sparse, a larger sparse matrix represents it: B - shift I is the Schur
/// complement after eliminating the first `hidden` rows, a negative definite block without shift.
/// The larger one has `hidden` additional negative eigenvalues (Haynsworth 1968).
struct ShiftedMatrices {
    std::shared_ptr<const SparseMatrix> A;
    SparseMatrix M; ///< positive semidefinite
    Index hidden = 0;

    SparseMatrix at(double shift) const { return *A - shift * M; }
};

/// Factors of more unknowns stand one at a time, because each needs gigabytes.
constexpr Index most_beside_another = 1 << 20;

/// Counts negative eigenvalues of symmetric matrices; equal patterns in a row are analyzed once. D
/// B D has the same inertia as B for any diagonal D > 0; D is chosen so that no entry exceeds 1. On
/// graded meshes the norm of B says nothing about the accuracy of its small entries.
class TrustedInertia {
public:
    /// The engine must count negative eigenvalues.
    TrustedInertia(const std::string& engine, int domain_dimension);

    /// The number of negative eigenvalues of the exact matrix, if it can be trusted. The doubt, and
    /// by far the backward error of solves, must be below the smallest eigenvalue of the scaled
    /// matrix, from inverse iteration. nullopt if not, or if the factorization breaks down. `sizes`
    /// and `share` of B are those of Doubt.
    std::optional<Index> negative(SparseMatrix B, const Vector& sizes, double share);

    /// B^-1 X, after a trusted count of at most most_beside_another rows.
    DenseMatrix solve(const DenseMatrix& X) const;

private:
    std::optional<Index> trusted(const std::shared_ptr<const SparseMatrix>& S, double share);

    std::string engine_;
    std::unique_ptr<LinearSolver> solver_;
    MatrixFacts facts_;
    Vector scale_; // D
};

/// Counts eigenvalues of a symmetric matrix below a shift, by the inertia of A - shift M.
class InertiaCounter {
public:
    /// The doubt is for A. The engine must count negative eigenvalues.
    InertiaCounter(ShiftedMatrices matrices, const std::string& engine, int domain_dimension,
                   Doubt doubt)
        : matrices_(std::move(matrices)),
          inertia_(engine, domain_dimension),
          doubt_(std::move(doubt)) {}

    /// The number of eigenvalues of the exact matrix below the shift, if it can be trusted: see
    /// TrustedInertia. The relative doubt must be below `gap`, the distance of the shift from the
    /// nearest eigenvalue.
    std::optional<Index> below(double shift, double gap);

    struct Counted {
        double shift;
        Index below;
    };

    /// A trusted count somewhere in the gap from `low` to `high`, with at least `known` eigenvalues
    /// below; nullopt if there is none.
    std::optional<Counted> between(double low, double high, Index known);

    /// A shift in (low, high) with `done` eigenvalues below it, as at low; the next eigenvalue is
    /// at most half as far from it as all others except `wanted`. Iterations about it converge
    /// where iterations about low would not. Bisects lengths above `length` by their exponents.
    double shift_close_to(Index done, Index wanted, double low, double high, double length);

private:
    ShiftedMatrices matrices_;
    TrustedInertia inertia_;
    Doubt doubt_;
};

/// A length below the nonzero eigenvalues, but not so small that a shift by it is nearly singular.
/// On graded meshes the coarse cells determine it.
double small_length(const SparseMatrix& B);

} // namespace polydec
