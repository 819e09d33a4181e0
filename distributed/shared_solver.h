// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear_solver.h"
#include "distributed/connected.h"

#include <memory>
#include <string>

namespace polydec {

/// What solves systems over all ranks, by PETSc.
struct SharedEngine {
    /// petsc.cg-hypre, petsc.cg-gamg, petsc.mumps, or auto: the first of them, and the last where
    /// that is not possible.
    std::string name = "auto";
    std::string options = {}; ///< PETSc's own, such as "-ksp_type fcg"; one that nobody reads is
                              ///< refused
};

/// ConstrainedSystem over all ranks; flags and weights are those of own unknowns.
struct SharedSystem {
    OwnedMat A = {};
    HeldUnknowns held = {};
    Vector weights = {};
    Definiteness definiteness = Definiteness::indefinite;
};

/// ConstrainedSolver over all ranks. Every function is collective, vectors have the own entries.
class SharedSolver {
public:
    /// Throws InvalidInput for an engine or option that there is not, SolverFailure if none of
    /// those tried can be set up.
    SharedSolver(const Ranks& ranks, SharedSystem system, const SharedEngine& engine);
    SharedSolver(SharedSolver&&) noexcept;
    ~SharedSolver();

    /// See ConstrainedSolver::solve. Throws SolverFailure if no engine solves it.
    Solution solve(const Vector& b, const Vector& fixed_values) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace polydec
