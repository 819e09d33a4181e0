// SPDX-License-Identifier: MIT
#pragma once

#include "solvers/time/diffusion.h"
#include "solvers/time/fixed_steps.h"

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

/// The heat equation du/dt = -Delta u for the forms of a space, with one factorization for all
/// steps of a Diffusion. Values that the conditions fix are 0 after every step, whatever they were
/// before.
class HeatSolver {
public:
    /// Throws like Diffusion, and InvalidInput if the time step is not positive.
    HeatSolver(const FormSpace& space, const HeatOptions& options);

    /// The form one step later. Throws InvalidInput like FormSpace::check.
    Cochain step(const Cochain& form) const;

private:
    FormSpace space_;
    double explicit_part_ = 0; // of the time step
    Diffusion diffusion_;
};

/// A form that cools by the steps of a HeatSolver.
class HeatRun final : public FixedSteps {
public:
    /// Throws like HeatSolver.
    HeatRun(const FormSpace& space, const Vector& start, const HeatOptions& options);

    std::vector<Cochain> forms() const override;
    std::optional<Fingerprint> fingerprint() const override;

private:
    void step(std::vector<Vector>& state) const override;

    FormSpace space_;
    HeatOptions options_;
    HeatSolver solver_;
    Vector start_;
};

} // namespace polydec
