// SPDX-License-Identifier: MIT
#include "solvers/flow/flow_solver.h"

#include "base/errors.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

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

double checked(double time_step) {
    if (!(time_step > 0) || !std::isfinite(time_step))
        throw InvalidInput(
            fmt::format("a time step of {} is given: expected a finite one above 0", time_step));
    return time_step;
}

double implicit_part(const FlowSteps& steps) {
    return checked(steps.time_step) *
           (steps.scheme == FlowScheme::implicit_midpoint ? 0.5 : Imex::g);
}

} // namespace

FlowSolver::FlowSolver(const IncompressibleFlow& flow, const FlowSteps& steps)
    : flow_(flow),
      steps_(steps),
      implicit_(flow.implicit_part(implicit_part(steps))),
      projection_(flow.implicit_part(0)) {}

Vector FlowSolver::step(const Vector& w) const {
    return steps_.scheme == FlowScheme::implicit_midpoint ? midpoint(w) : imex(w);
}

Vector FlowSolver::midpoint(const Vector& w) const {
    const Vector momentum = flow_.momentum(w);
    Vector middle = w;
    double change = 0;
    for (int pass = 0; pass < steps_.most_passes && std::isfinite(change); ++pass) {
        const Vector next =
            implicit_.solve(momentum + steps_.time_step / 2 * flow_.inertia(middle)).flux;
        const Vector by = next - middle;
        change = by.isZero(0) ? 0 : std::sqrt(flow_.ratio_of_energies(by, next));
        middle = next;
        if (change <= steps_.tolerance)
            return 2 * middle - w;
    }
    throw SolverFailure(
        fmt::format("the midpoint of a step of {:.6g} of a flow was not found in {} "
                    "passes: the last one changed it by {:.2g}\nTake steps well "
                    "below the exchange time, {:.6g}.",
                    steps_.time_step, steps_.most_passes, change, flow_.exchange_time(w)));
}

Vector FlowSolver::imex(const Vector& w) const {
    const double dt = steps_.time_step;
    const Vector momentum = flow_.momentum(w);
    std::array<Vector, 4> inertia;
    std::array<Vector, 3> friction;
    inertia[0] = flow_.inertia(w);
    for (int stage = 0; stage < 3; ++stage) {
        Vector right_side = momentum;
        for (int i = 0; i <= stage; ++i)
            right_side += dt * Imex::inertia[stage][i] * inertia[i];
        for (int i = 0; i < stage; ++i)
            right_side += dt * Imex::friction[stage][i] * friction[i];
        const Vector at_stage = implicit_.solve(right_side).flux;
        inertia[stage + 1] = flow_.inertia(at_stage);
        friction[stage] = flow_.friction(at_stage);
    }
    Vector result = momentum;
    for (int i = 0; i < 3; ++i)
        result += dt * Imex::friction[2][i] * (inertia[i + 1] + friction[i]);
    return projection_.solve(result).flux;
}

} // namespace polydec
