// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <cstdint>
#include <functional>
#include <string>

namespace polydec {

/// A symmetric matrix as an operator: apply(x, y) writes A x to y, both of `size` entries.
struct SymmetricOperator {
    Index size = 0;
    std::function<void(const Vector& x, Vector& y)> apply = {};

    /// Writes A X to Y for several columns at once, where that is cheaper, as in solves with a
    /// factorization. Empty: apply() is called for each column.
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
    Index converged = 0;      ///< number found; smaller than requested if iterations ran out
    Index operations = 0;     ///< products with the operator
};

/// Finds eigenpairs of symmetric operators. It may miss copies of multiple eigenvalues, and
/// eigenvalues in invariant subspaces orthogonal to the start vector. To find all, count by inertia
/// and deflate.
class EigenSolver {
public:
    EigenSolver() = default;
    EigenSolver(const EigenSolver&) = delete;
    EigenSolver& operator=(const EigenSolver&) = delete;
    virtual ~EigenSolver() = default;

    virtual std::string name() const = 0;

    /// The `count` (algebraically) largest eigenpairs, 0 <= count <= size. At the limit of restarts
    /// it returns the converged pairs. Throws InvalidInput for impossible counts, options or start
    /// vectors; SolverFailure if the operator gives NaN or infinity or the iteration breaks down.
    /// Passes on errors of polydec thrown by apply().
    EigenPairs largest(const SymmetricOperator& A, Index count,
                       const EigenOptions& options = {}) const;

protected:
    /// The default dimension of this engine's subspace.
    virtual std::int64_t usual_dimension(Index count) const;

    /// The same for 1 <= count <= size and complete options: krylov_dimension lies between count
    /// and size, start is not zero. Both apply() and apply_to_columns() are set and throw on NaN.
    virtual EigenPairs compute(const SymmetricOperator& A, Index count,
                               const EigenOptions& options) const = 0;
};

} // namespace polydec
