// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear_solver.h"
#include "backends/spectra/inertia.h"
#include "backends/spectra/scaled_pencil.h"

#include <memory>
#include <string>
#include <utility>

namespace polydec {

/// Solves with B - shift I, B the matrix of a pencil, for one shift at a time.
class ShiftedSolver {
public:
    /// Keeps a reference to the pencil. The facts are those of all shifts.
    ShiftedSolver(const ScaledPencil& pencil, std::string engine, const MatrixFacts& facts)
        : pencil_(pencil), engine_(std::move(engine)), facts_(facts) {}

    /// Factorizes B - shift I, of this definiteness.
    void set(double shift, Definiteness definiteness);
    bool is_set() const { return is_set_; }
    double shift() const { return shift_; }

    /// (B - shift I)^-1 Y, after set().
    DenseMatrix solve(const DenseMatrix& Y);

    /// Frees a factor of more unknowns, too large to stand beside another; solve() computes it
    /// again.
    void make_room(Index most = most_beside_another);

    /// The engine of the last solve.
    std::string engine() const { return solver_ ? solver_->report().engine : used_; }

private:
    void factorize();

    const ScaledPencil& pencil_;
    std::string engine_, used_;
    MatrixFacts facts_;
    std::unique_ptr<LinearSolver> solver_; // null without factor
    double shift_ = 0;
    bool is_set_ = false;
};

} // namespace polydec
