// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/shared_solver.h"

namespace polydec {

/// A PETSc engine with the matrix that it solves.
class Ksp {
public:
    /// The names of engines, in the order in which `auto` tries them.
    static std::vector<std::string> engines(Definiteness definiteness);

    /// Collective. Treats the matrix as symmetric. Throws InvalidInput for an unknown engine and
    /// invalid or unused options, SolverFailure if the setup fails.
    Ksp(const Ranks& ranks, Mat matrix, const SharedEngine& engine, Definiteness definiteness);
    ~Ksp();
    Ksp(const Ksp&) = delete;
    Ksp& operator=(const Ksp&) = delete;

    /// Collective: solves A x = b, to the engine's accuracy.
    Vector solve(const Vector& b, Index& iterations);

    /// Collective: the number of negative eigenvalues of the matrix, by the inertia of its factor.
    /// Only for petsc.mumps.
    GlobalIndex negative_pivots() const;

private:
    void set_up(const std::string& own_options, double room_of_mumps);
    void check_setup() const;
    [[noreturn]] void fail(const std::string& why) const;

    Ranks ranks_;
    SharedEngine engine_;
    Mat matrix_;
    struct Solver;
    std::unique_ptr<Solver> solver_;
};

} // namespace polydec
