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

/// A form of a space that changes in time, and what of its rate is stiff: diffusion, -nu Delta u.
/// Without a stiff part the conditions of the space fix nothing.
struct Unknown {
    FormSpace space;
    Vector start;         ///< a value for each cell
    double diffusion = 0; ///< nu, at least 0; length squared over time, of a mesh's input

    /// What is known on the boundary at a time, as PoissonSolver takes it; none: 0.
    std::function<BoundaryForms(double time)> boundary = {};

    /// Another stiff part, in place of diffusion.
    std::shared_ptr<Diffusion> stiff = {};
};

/// What is not stiff: of each unknown the rate at all its cells, at a time of these forms; an empty
/// one is 0.
using Reaction = std::function<std::vector<Vector>(double time, const std::vector<Cochain>& forms)>;

struct EvolutionOptions {
    double time = 0; ///< at the beginning
    std::string integrator = "runge-kutta";
    IntegratorOptions steps = {};
    std::string linear_solver = "auto";
    /// A march stops where this goes through 0.
    std::function<double(double time, const std::vector<Cochain>& forms)> event = {};
    std::string label = {}; ///< of what the functions compute, for checkpoints
};

/// The largest coefficient of a form: of its values over the sizes of cells, by which Evolution
/// measures the errors of steps, in the units of the input. Throws InvalidInput for a form of other
/// cells.
double largest_coefficient(const Cells& cells, const Cochain& form);

/// Forms that change in time: u_i' = -nu_i Delta u_i + f_i(t, u_1, u_2, ..), for primal and dual
/// forms of any degrees. The steps are what the tolerances ask for, however fine the
/// mesh is, since diffusion is solved for; or fixed ones, as "backward-euler" and
/// "implicit-midpoint" take them alone. A step's error is measured in values over the sizes of
/// cells, so that the absolute tolerance is one of coefficients. Times and rates are those of the
/// caller, of lengths of a mesh's input.
class Evolution final : public Run {
public:
    /// Throws InvalidInput like FormSpace::check and Diffusion, and, numbering the unknown from 0,
    /// for a stiff part of other forms; BackendUnavailable or InvalidInput for an integrator that
    /// is not there.
    Evolution(std::vector<Unknown> unknowns, Reaction reaction = {}, EvolutionOptions options = {});

    double time() const override;
    std::vector<Cochain> forms() const override;

    /// Progress is told at each evaluation on the way. Throws like Integrator::advance.
    Arrival march(double until, const TimeListener& progress = {}) override;
    std::vector<Vector> state() const override;
    void resume(double time, const std::vector<Vector>& state) override;
    bool resumes_anywhere() const override;

    /// What the reaction and the data on the boundary give at the start is part of it as well.
    std::optional<Fingerprint> fingerprint() const override;

    IntegratorReport report() const;

private:
    struct Equation;
    void begin(double time, const Vector& values, const Vector& memory);

    std::shared_ptr<Equation> equation_;
    std::unique_ptr<Integrator> integrator_;
};

} // namespace polydec
