// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear_solver.h"
#include "base/shared.h"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace polydec {

/// A symmetric system A u = b with some unknowns prescribed. It may be singular: on every connected
/// component that nothing ties down, u is free up to a constant.
struct ConstrainedSystem {
    SparseMatrix A = {};
    std::vector<bool> fixed = {}; ///< unknowns whose value is prescribed
    std::vector<bool> tied = {};  ///< unknowns tied down, but not fixed, by boundary terms in A
    Vector weights = {};          ///< of the mean on a free component, with a positive sum
    Definiteness definiteness = Definiteness::indefinite; ///< of A where nothing is fixed
    int domain_dimension = 0;
    int degree = 0; ///< of the cells that carry the unknowns, for messages
};

/// Compatibility of the right-hand side on components that are free up to a constant.
struct Compatibility {
    Index free_components = 0;
    double worst = 0;  ///< largest |sum of b| / sum |b|; the sum is removed before solving
    double excess = 0; ///< the sum of b on this component
};

/// The connected components of unknowns on which a solution is free up to a constant: those without
/// fixed or tied unknowns. Each row of a matrix connects the unknowns of its entries: of those that
/// are not 0, and of the diagonal.
class FreeComponents {
public:
    using Sums = Eigen::Matrix<long double, Eigen::Dynamic, 1>; ///< as exact as their terms

    FreeComponents() = default;
    FreeComponents(const SparseMatrix& graph, const std::vector<bool>& fixed,
                   const std::vector<bool>& tied, Vector weights);
    /// Given the component of each unknown, -1 if it is not free. If components continue in other
    /// processes, `over_all` adds their sums.
    FreeComponents(std::vector<Index> component, Index count, Vector weights,
                   std::function<Sums(Sums)> over_all);

    /// Whether the weights of each component have a positive sum; the first constructor throws
    /// InvalidInput if not.
    bool have_means() const;

    Index count() const { return static_cast<Index>(weights_of_all_.size()); }
    /// The component of an unknown; -1 if it is not free.
    Index of(Index unknown) const { return component_[unknown]; }

    /// Projects a right-hand side onto the range: subtracts its sum on each component, distributed
    /// by the weights. Where only rounding is left, it is 0.
    Compatibility balance(Vector& b) const;

    /// Makes the weighted mean on each component 0.
    void remove_means(Vector& u) const;

private:
    template <typename Term>
    Sums sums(Index count, Term term) const;

    struct Run {
        Index component, begin, end; ///< of unknowns one after the other
    };
    static std::vector<Run> runs_of(const std::vector<Index>& component);

    std::vector<Index> component_; // of unknowns
    std::vector<Run> runs_;        // of those that are free
    Vector weights_;
    std::function<Sums(Sums)> over_all_ = [](Sums own) { return own; };
    Sums weights_of_all_; // of components
};

/// Throws InvalidInput for weights without means.
[[noreturn]] void refuse_means();

/// Throws InvalidInput, naming the cell, if a right-hand side on cells of a degree is not finite,
/// as products of finite data with volumes and weights can be.
void check_loads(const char* what, const Vector& loads, int degree);

/// A warning if the removed mean exceeds rounding.
std::vector<std::string> warning_of(const Compatibility& compatibility);

/// The solution of a system, with reports of how the solve went.
struct Solution {
    Vector values;
    SolveReport report;
    Compatibility compatibility;
    std::vector<std::string> warnings = {}; ///< why it may differ from the requested one
};

/// Solves constrained systems with one factorization. On free components it removes the
/// incompatible part of b (its sum, distributed by the weights), and the weighted mean of u is 0.
/// Copies share the factorization; use them from one thread at a time.
class ConstrainedSolver {
public:
    /// Throws InvalidInput for sizes that do not fit, SolverFailure if A cannot be factorized.
    ConstrainedSolver(ConstrainedSystem&& system, const std::string& engine);
    ConstrainedSolver(const ConstrainedSystem& system, const std::string& engine)
        : ConstrainedSolver(ConstrainedSystem(system), engine) {}

    /// Solves with u = fixed_values on the fixed unknowns; fixed_values has one entry per unknown.
    Solution solve(const Vector& b, const Vector& fixed_values) const;

    const FreeComponents& components() const { return components_; }

private:
    ConstrainedSystem system_;
    std::vector<Index> unknowns_; // indices of the free unknowns
    FreeComponents components_;
    Shared<LinearSolver> solver_;
};

} // namespace polydec
