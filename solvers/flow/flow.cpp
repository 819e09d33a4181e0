// SPDX-License-Identifier: MIT
#include "solvers/flow/flow.h"

#include "base/checks.h"
#include "base/errors.h"
#include "base/exponent.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

namespace polydec {

namespace {

/// Scheme (3,4,3): the weights of friction in stages 1 to 3, the last ones also those of the step;
/// of inertia in stages 1 to 3, of stages 0 to 2. g is the root of 6 x^3 - 18 x^2 + 9 x - 1 that
/// makes it L-stable; what inertia has free is Ascher, Ruuth and Spiteri's choice.
struct Imex {
    static constexpr double g = 0.43586652150845899942;
    static constexpr double b1 = -1.5 * g * g + 4 * g - 0.25, b2 = 1.5 * g * g - 5 * g + 1.25;
    static constexpr double a = 0.5529291479;
    static constexpr double a31 = (1 - 4.5 * g + 1.5 * g * g) * a +
                                  (2.75 - 10.5 * g + 3.75 * g * g) * a - 3.5 + 13 * g - 4.5 * g * g;
    static constexpr double a32 = (-1 + 4.5 * g - 1.5 * g * g) * a +
                                  (-2.75 + 10.5 * g - 3.75 * g * g) * a + 4 - 12.5 * g +
                                  4.5 * g * g;
    static constexpr std::array<std::array<double, 3>, 3> friction{
        {{g, 0, 0}, {(1 - g) / 2, g, 0}, {b1, b2, g}}};
    static constexpr std::array<std::array<double, 3>, 3> inertia{
        {{g, 0, 0}, {a31, a32, 0}, {1 - 2 * a, a, a}}};
};

double implicit_part(const FlowSteps& steps) {
    return steps.time_step * (steps.scheme == FlowScheme::implicit_midpoint ? 0.5 : Imex::g);
}

} // namespace

Flow::Flow(const IncompressibleFlow& equations, const Vector& start, const FlowSteps& steps)
    : FixedSteps(steps.time_step, {start}),
      equations_(equations),
      steps_(steps),
      start_(start),
      implicit_(equations.implicit_part(implicit_part(steps))),
      projection_(equations.implicit_part(0)) {
    const Discretization& mesh = equations.mesh();
    check_values("fluxes", start, mesh.complex().size(mesh.dimension() - 1));
    check_not_negative("FlowSteps::tolerance", steps.tolerance);
    if (steps.most_passes < 1)
        throw InvalidInput(
            fmt::format("FlowSteps::most_passes is {}: expected at least 1", steps.most_passes));
}

void Flow::step(std::vector<Vector>& state) const {
    const bool is_midpoint = steps_.scheme == FlowScheme::implicit_midpoint;
    state[0] = is_midpoint ? midpoint(state[0]) : imex(state[0]);
}

StepPlan Flow::limit() const {
    const double time = equations_.exchange_time(flux());
    return {.limit = std::isfinite(time)
                         ? fmt::format("the flow, which exchanges the contents of a cell in {:.3g}",
                                       time)
                         : "the wanted accuracy",
            .advice = "FlowSteps::time_step changes that"};
}

std::vector<Cochain> Flow::forms() const {
    return {{Side::primal, equations_.mesh().dimension() - 1, flux()}};
}

std::vector<std::string> Flow::warnings() const {
    std::vector<std::string> result;
    if (const Points& walls = equations_.options().wall_velocity;
        walls.size() > 0 && flux().isZero(0))
        result = warning_of_rest(walls.reshaped(), equations_.rate(flux()));
    const double rate =
        steps_.scheme == FlowScheme::implicit_midpoint ? equations_.friction_rate() : 0;
    if (rate * time_step() > 2)
        result.push_back(fmt::format(
            "friction takes the smallest eddies away at rates of up to {:.3g}, too fast for steps "
            "of {:.3g} by the midpoint: they change sign in each step instead of dying away; use "
            "FlowScheme::imex, or steps below {:.3g}",
            rate, time_step(), 2 / rate));
    return result;
}

std::optional<Fingerprint> Flow::fingerprint() const {
    const FlowOptions& given = equations_.options();
    Fingerprint result;
    result.add("flow").add(equations_.mesh()).add(start_).add(steps_.time_step);
    result.add(steps_.scheme).add(steps_.tolerance).add(steps_.most_passes);
    result.add(given.viscosity).add(given.everywhere).add(given.facets.size());
    for (const FlowBoundary kind : given.facets)
        result.add(kind);
    result.add(given.boundary_flux).add(DenseMatrix(given.wall_velocity)).add(given.rotation);
    return result.add(given.linear_solver);
}

Vector Flow::midpoint(const Vector& w) const {
    const Vector momentum = equations_.momentum(w);
    Vector middle = w;
    // the next one grows as the square, and its energy as the fourth power
    constexpr int most_growth = std::numeric_limits<double>::max_exponent / 4;
    double change = 0;
    for (int pass = 0, first = exponent_of(w);
         pass < steps_.most_passes && exponent_of(middle) - first < most_growth; ++pass) {
        const Vector next =
            implicit_.solve(momentum + steps_.time_step / 2 * equations_.inertia(middle)).flux;
        const Vector by = next - middle;
        change = by.isZero(0) ? 0 : std::sqrt(equations_.ratio_of_energies(by, next));
        middle = next;
        if (pass == 0)
            first = exponent_of(middle);
        if (change <= steps_.tolerance)
            return 2 * middle - w;
    }
    throw SolverFailure(fmt::format("the midpoint of a time step of {:.6g} did not converge in {} "
                                    "passes: the last pass changed it by {:.2g}\n"
                                    "Use steps well below the exchange time, {:.6g}.",
                                    steps_.time_step, steps_.most_passes, change,
                                    equations_.exchange_time(w)));
}

Vector Flow::imex(const Vector& w) const {
    const double dt = steps_.time_step;
    const Vector momentum = equations_.momentum(w);
    std::array<Vector, 4> inertia;
    std::array<Vector, 3> friction;
    inertia[0] = equations_.inertia(w);
    for (int stage = 0; stage < 3; ++stage) {
        Vector right_side = momentum;
        for (int i = 0; i <= stage; ++i)
            right_side += dt * Imex::inertia[stage][i] * inertia[i];
        for (int i = 0; i < stage; ++i)
            right_side += dt * Imex::friction[stage][i] * friction[i];
        const Vector at_stage = implicit_.solve(right_side).flux;
        inertia[stage + 1] = equations_.inertia(at_stage);
        friction[stage] = equations_.friction(at_stage);
    }
    Vector result = momentum;
    for (int i = 0; i < 3; ++i)
        result += dt * Imex::friction[2][i] * (inertia[i + 1] + friction[i]);
    return projection_.solve(result).flux;
}

} // namespace polydec
