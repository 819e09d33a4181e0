// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear_solver.h"

#include <memory>
#include <string>
#include <vector>

namespace polydec {

/// A symmetric system A u = b in which some unknowns are prescribed and whose remaining part may be
/// singular: on every connected component that nothing ties down, u is free up to a constant.
struct ConstrainedSystem {
    SparseMatrix A;
    std::vector<bool> fixed; ///< unknowns whose value is prescribed
    std::vector<bool> tied;  ///< unknowns that boundary data in A tie down without fixing them
    Vector weights;          ///< positive; the mean on a free component is weighted by these
    Definiteness definiteness = Definiteness::indefinite; ///< of A where nothing is fixed
    int domain_dimension = 0;
};

/// How the right-hand side fared on components that are free up to a constant.
struct Compatibility {
    Index free_components = 0;
    double worst = 0; ///< largest |sum of b| / sum |b| over them; removed before solving
};

/// What a solve gives, and how it went; of several systems, a column each, the worst.
template <class Values>
struct Solution {
    Values values;
    SolveReport report;
    Compatibility compatibility;
};

/// Solves constrained systems with one factorization. On free components the part of b that no u
/// can give (its sum, shared out by the weights) is removed, and the weighted mean of u is 0.
/// An object is used by one thread at a time.
class ConstrainedSolver {
public:
    /// Throws InvalidInput for sizes that do not fit, SolverFailure if A cannot be factorized.
    ConstrainedSolver(ConstrainedSystem&& system, const std::string& engine);
    ConstrainedSolver(const ConstrainedSystem& system, const std::string& engine)
        : ConstrainedSolver(ConstrainedSystem(system), engine) {}

    /// u with u = fixed_values on the fixed unknowns. fixed_values has an entry for every unknown.
    Solution<Vector> solve(const Vector& b, const Vector& fixed_values) const;

    /// The same for several systems, a column each.
    Solution<DenseMatrix> solve_all(const DenseMatrix& b, const DenseMatrix& fixed_values) const;

private:
    void find_components();

    ConstrainedSystem system_;
    std::vector<Index> unknowns_;  // those solved for
    std::vector<Index> component_; // of each unknown, -1 if fixed or tied down
    Index free_components_ = 0;
    std::unique_ptr<LinearSolver> solver_;
};

} // namespace polydec
