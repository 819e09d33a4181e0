// SPDX-License-Identifier: MIT
#include "backends/spectra/shifted_solver.h"

#include "backends/registry.h"

namespace polydec {

void ShiftedSolver::set(double shift, Definiteness definiteness) {
    shift_ = shift;
    is_set_ = true;
    facts_.definiteness = pencil_.matrices().hidden > 0 ? Definiteness::indefinite : definiteness;
    factorize();
}

void ShiftedSolver::factorize() {
    if (!solver_)
        solver_ = make_linear_solver(engine_);
    const auto shifted = std::make_shared<SparseMatrix>();
    pencil_.matrices().at(shift_).swap(*shifted); // Eigen's matrices cannot be moved
    solver_->factorize(shifted, facts_);
}

DenseMatrix ShiftedSolver::solve(const DenseMatrix& Y) {
    if (!solver_)
        factorize();
    return pencil_.from_matrices(solver_->solve(pencil_.to_matrices(Y)));
}

void ShiftedSolver::make_room(Index most) {
    if (!solver_ || pencil_.size() <= most)
        return;
    used_ = engine();
    solver_.reset();
}

} // namespace polydec
