// SPDX-License-Identifier: MIT
#pragma once

#include "solvers/diffusion.h"
#include "solvers/fixed_steps.h"

#include <string>

namespace polydec {

/// How a step of the heat equation is taken.
enum class HeatScheme {
    backward_euler, ///< first order in time; no new extremes on functions where A has none
    crank_nicolson, ///< second order in time
};

struct HeatOptions {
    double time_step = 0; ///< in squares of lengths, of a mesh's input
    HeatScheme scheme = HeatScheme::backward_euler;
    std::string linear_solver = "auto";
};

/// The heat equation du/dt = -Delta u for primal or dual forms of any degree, with one
/// factorization for all steps. Without conditions given, those hold that need nothing done about
/// the boundary (see built_in_conditions): for 0-forms nothing flows through the boundary (Neumann)
/// if they are primal; values are 0 on it (Dirichlet) if they are dual. Where star_k or star_(k-1)
/// is a matrix, each step solves for the codifferential beside the form: the inverse of star_(k-1)
/// is dense, or its entries are of such different sizes that products with it lose the star's
/// digits.
class HeatSolver {
public:
    /// Throws InvalidInput if there is no such degree, the mass of these forms is not positive or a
    /// star that must be inverted has a zero (naming the cells), or the time step is not positive.
    HeatSolver(const Cells& cells, Side side, int degree, const HeatOptions& options)
        : HeatSolver(cells, built_in_conditions(side), side, degree, options) {}

    /// Under homogeneous conditions on the boundary, those of conditioned_complex: values that they
    /// fix are 0 after every step, whatever they were before. Dual forms need no boundary facet to
    /// have a dual. Throws also if there are conditions but not one for each facet.
    HeatSolver(const Cells& cells, const BoundaryConditions& conditions, Side side, int degree,
               const HeatOptions& options);

    /// The form one step later. Throws InvalidInput for a form of another kind.
    Cochain step(const Cochain& form) const;

private:
    CellComplex complex_;
    double explicit_part_ = 0; // of the time step
    Diffusion diffusion_;
};

/// A form that cools by the steps of a HeatSolver.
class HeatRun final : public FixedSteps {
public:
    /// Throws like HeatSolver.
    HeatRun(const Cells& cells, const BoundaryConditions& conditions, const Cochain& start,
            const HeatOptions& options);

    std::vector<Cochain> forms() const override;
    std::optional<Fingerprint> fingerprint() const override;

private:
    void step(std::vector<Vector>& state) const override;

    HeatSolver solver_;
    Cochain start_;
    std::function<Fingerprint()> problem_;
};

} // namespace polydec
