// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear_solver.h"
#include "dec/cochain.h"

#include <memory>
#include <string>

namespace polydec {

/// How a step of the heat equation is taken.
enum class HeatScheme {
    backward_euler, ///< first order in time; no new extremes on functions where A has none
    crank_nicolson, ///< second order in time
};

struct HeatOptions {
    double time_step = 0;
    HeatScheme scheme = HeatScheme::backward_euler;
    std::string linear_solver = "auto";
};

/// The heat equation du/dt = -Delta u for primal or dual forms of any degree, with one
/// factorization for all steps. Boundary conditions are the natural ones; forms that vanish on the
/// boundary are had on the complex relative to it.
class HeatSolver {
public:
    /// Throws InvalidInput if there is no such degree, the mass of these forms is not positive or a
    /// star that must be inverted has a zero (naming the cells), or the time step is not positive.
    HeatSolver(const CellComplex& complex, const CellVolumes& volumes, Side side, int degree,
               const HeatOptions& options);

    /// The form one step later. Throws InvalidInput for a form of another kind.
    Cochain step(const Cochain& form);

private:
    CellComplex complex_;
    Side side_;
    int degree_;
    double explicit_part_; // of the time step
    SparseMatrix stiffness_;
    Vector mass_;
    std::unique_ptr<LinearSolver> solver_;
};

} // namespace polydec
