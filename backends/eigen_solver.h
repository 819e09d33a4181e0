// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <cstdint>
#include <functional>
#include <string>

namespace polydec {

/// A symmetric matrix given by what it does: apply(x, y) writes A x to y, both of `size` entries.
struct SymmetricOperator {
    Index size = 0;
    std::function<void(const Vector& x, Vector& y)> apply = {};

    /// Writes A X to Y, for as many columns as X has, where several at once cost less than one by
    /// one, as solves with a factorization do. Empty: apply() is called for each column.
    std::function<void(const DenseMatrix& X, DenseMatrix& Y)> apply_to_columns = {};
};

struct EigenOptions {
    Index krylov_dimension = 0; ///< 0: the engine's choice; at least count + 1, at most the size
    double tolerance = 1e-10;   ///< |A v - lambda v| <= tolerance |lambda| for unit v
    Index max_restarts = 1000;
    Vector start = {}; ///< empty: pseudo-random, the same in every run
};

/// Eigenpairs of one operator, largest eigenvalue first.
struct EigenPairs {
    Vector values = {};       ///< descending
    DenseMatrix vectors = {}; ///< orthonormal columns, one per value
    Index converged = 0;      ///< how many there are; fewer than asked for if iterations ran out
    Index operations = 0;     ///< products with the operator
};

/// Finds eigenpairs of symmetric operators. Copies of multiple eigenvalues may be missed, and
/// eigenvalues in invariant subspaces the start vector has no part in: who needs all of them has to
/// count by inertia and to deflate.
class EigenSolver {
public:
    EigenSolver() = default;
    EigenSolver(const EigenSolver&) = delete;
    EigenSolver& operator=(const EigenSolver&) = delete;
    virtual ~EigenSolver() = default;

    virtual std::string name() const = 0;

    /// The `count` pairs of (algebraically) largest eigenvalue, 0 <= count <= size. Running into
    /// the limit of restarts is no failure: what has converged is returned. Throws InvalidInput for
    /// impossible counts, options or start vectors; SolverFailure if the operator gives NaN or
    /// infinity or the iteration breaks down. Errors of polydec that apply() throws pass through.
    EigenPairs largest(const SymmetricOperator& A, Index count,
                       const EigenOptions& options = {}) const;

protected:
    /// The dimension of the subspace that suits this engine.
    virtual std::int64_t usual_dimension(Index count) const;

    /// The same for 1 <= count <= size and options that are filled in: krylov_dimension lies
    /// between count and size, start is not zero; apply() and apply_to_columns(), which are both
    /// there, refuse to give NaN.
    virtual EigenPairs compute(const SymmetricOperator& A, Index count,
                               const EigenOptions& options) const = 0;
};

} // namespace polydec
