// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear_solver.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace polydec {

/// A symmetric system A u = b in which some unknowns are prescribed and whose remaining part may be
/// singular: on every connected component that nothing ties down, u is free up to a constant.
struct ConstrainedSystem {
    SparseMatrix A = {};
    std::vector<bool> fixed = {}; ///< unknowns whose value is prescribed
    std::vector<bool> tied = {};  ///< unknowns that boundary data in A tie down without fixing them
    Vector weights = {};          ///< positive; the mean on a free component is weighted by these
    Definiteness definiteness = Definiteness::indefinite; ///< of A where nothing is fixed
    int domain_dimension = 0;
    int degree = 0; ///< of the cells that carry the unknowns, for messages
};

/// How the right-hand side fared on components that are free up to a constant.
struct Compatibility {
    Index free_components = 0;
    double worst = 0; ///< largest |sum of b| / sum |b| over them; removed before solving
};

/// The connected components of unknowns on which a solution is free up to a constant: those of the
/// graph of a matrix that touch no fixed or tied unknown.
class FreeComponents {
public:
    FreeComponents() = default;
    FreeComponents(const SparseMatrix& graph, const std::vector<bool>& fixed,
                   const std::vector<bool>& tied, Vector weights);

    Index count() const { return static_cast<Index>(weights_of_all_.size()); }
    /// -1 where nothing is free.
    Index of(Index unknown) const { return component_[unknown]; }

    /// Takes from a right-hand side what no solution can give: its sum on each component, shared
    /// out by the weights.
    Compatibility balance(Vector& b) const;

    /// Makes the weighted mean on each component 0.
    void remove_means(Vector& u) const;

private:
    std::vector<Index> component_; // of unknowns
    Vector weights_;
    Vector weights_of_all_; // of components
};

/// Throws InvalidInput, naming the cell, where a right-hand side, that of cells of a degree, is no
/// number: data are, but their products with volumes and weights need not be.
void check_loads(const char* what, const Vector& loads, int degree);

/// A warning if a mean was removed that is more than rounding.
std::vector<std::string> warning_of(const Compatibility& compatibility);

/// What a solve gives, and how it went.
struct Solution {
    Vector values;
    SolveReport report;
    Compatibility compatibility;
    std::vector<std::string> warnings = {}; ///< why it may be another one than was asked for
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
    Solution solve(const Vector& b, const Vector& fixed_values) const;

    const FreeComponents& components() const { return components_; }

private:
    ConstrainedSystem system_;
    std::vector<Index> unknowns_; // those solved for
    FreeComponents components_;
    std::unique_ptr<LinearSolver> solver_;
};

} // namespace polydec
