// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear_solver.h"
#include "base/shared.h"
#include "distributed/connected.h"

#include <string>

namespace polydec {

/// A PETSc engine for systems over all ranks.
struct SharedEngine {
    /// petsc.cg-hypre, petsc.cg-gamg, petsc.mumps, or auto: the first of them, or else the last.
    std::string name = "auto";
    std::string options = {}; ///< PETSc's own, such as "-ksp_type fcg"; unused options throw
};

/// ConstrainedSystem over all ranks; flags and weights are for own unknowns.
struct SharedSystem {
    OwnedMat A = {};
    HeldUnknowns held = {};
    Vector weights = {};
    Definiteness definiteness = Definiteness::indefinite;
};

/// ConstrainedSolver over all ranks. Every function is collective; vectors have own entries.
class SharedSolver {
public:
    /// Throws InvalidInput for an unknown engine or option, SolverFailure if no engine can be set
    /// up.
    SharedSolver(const Ranks& ranks, SharedSystem system, const SharedEngine& engine);

    /// See ConstrainedSolver::solve. Throws SolverFailure if no engine solves it.
    Solution solve(const Vector& b, const Vector& fixed_values) const;

private:
    struct State;
    Shared<State> state_;
};

} // namespace polydec
