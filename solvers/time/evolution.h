// SPDX-License-Identifier: MIT
#pragma once

#include "solvers/time/diffusion.h"
#include "solvers/time/run.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace polydec {

/// A time-dependent form of a space, and the stiff part of its rate: diffusion, -nu Delta u.
/// Without a stiff part, the conditions of the space fix nothing.
struct Unknown {
    FormSpace space;
    Vector start;         ///< one value per cell
    double diffusion = 0; ///< nu, at least 0; length squared over time, in the input's units

    /// Boundary data at a time, as PoissonSolver takes them; none: 0.
    std::function<BoundaryForms(double time)> boundary = {};

    /// Another stiff part, which replaces diffusion.
    std::shared_ptr<const Diffusion> stiff = {};
};

/// The non-stiff part: the rate of each unknown at all its cells, for these forms at a time. An
/// empty vector means 0.
using Reaction = std::function<std::vector<Vector>(double time, const std::vector<Cochain>& forms)>;

struct EvolutionOptions {
    double time = 0; ///< at the beginning
    std::string integrator = "runge-kutta";
    IntegratorOptions steps = {};
    std::string linear_solver = "auto";
    /// A march stops at a zero of this function.
    std::function<double(double time, const std::vector<Cochain>& forms)> event = {};
    std::string label = {}; ///< names what the functions compute, for checkpoints
};

/// Integrates u_i' = -nu_i Delta u_i + f_i(t, u_1, u_2, ..), for primal and dual forms of any
/// degrees. Diffusion is implicit, so the tolerances alone determine the steps, however fine the
/// mesh. "backward-euler" and "implicit-midpoint" take fixed steps instead. The error of a step is
/// measured in values over cell sizes, so the absolute tolerance applies to coefficients; by
/// default, it follows the largest one so far of each unknown. Times and rates are in the caller's
/// units, lengths in the input's.
class Evolution final : public Run {
public:
    /// Throws InvalidInput like FormSpace::check and Diffusion, and, with the number of the unknown
    /// from 0, for a stiff part of other forms; BackendUnavailable or InvalidInput for an
    /// integrator that does not exist.
    Evolution(std::vector<Unknown> unknowns, Reaction reaction = {}, EvolutionOptions options = {});

    double time() const override;
    std::vector<Cochain> forms() const override;

    /// Reports progress at each evaluation on the way. Throws like Integrator::advance.
    Arrival march(double until, const TimeListener& progress = {}) override;
    StepPlan plan(const std::vector<double>& times) const override;
    std::vector<Vector> state() const override;
    void resume(double time, const std::vector<Vector>& state) override;
    bool resumes_anywhere() const override;

    /// Includes the values of the reaction and of the boundary data at the start.
    std::optional<Fingerprint> fingerprint() const override;

    IntegratorReport report() const;

private:
    struct Equation;
    void begin(double time, const Vector& values, const Vector& memory);

    std::shared_ptr<Equation> equation_;
    std::unique_ptr<Integrator> integrator_;
};

} // namespace polydec
