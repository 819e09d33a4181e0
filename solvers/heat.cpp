// SPDX-License-Identifier: MIT
#include "solvers/heat.h"

#include "base/errors.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace polydec {

HeatSolver::HeatSolver(const FormSpace& space, const HeatOptions& options)
    : space_(space), diffusion_(space, 1, options.linear_solver) {
    if (!(options.time_step > 0) || !std::isfinite(options.time_step))
        throw InvalidInput(fmt::format("a time step of {} is given: expected a finite one above 0",
                                       options.time_step));
    const bool implicit = options.scheme == HeatScheme::backward_euler;
    const double implicit_part = implicit ? options.time_step : options.time_step / 2;
    explicit_part_ = options.time_step - implicit_part;
    diffusion_.prepare(implicit_part);
}

Cochain HeatSolver::step(const Cochain& form) const {
    space_.check(form);
    const Vector next = diffusion_.solve(space_.restrict(form.values), explicit_part_);
    return {form.side, form.degree, space_.extend(next)};
}

HeatRun::HeatRun(const FormSpace& space, const Vector& start, const HeatOptions& options)
    : FixedSteps(options.time_step, {start}),
      space_(space),
      options_(options),
      solver_(space, options),
      start_(start) {}

void HeatRun::step(std::vector<Vector>& state) const {
    state[0] = solver_.step({space_.side(), space_.degree(), state[0]}).values;
}

std::vector<Cochain> HeatRun::forms() const {
    return {{space_.side(), space_.degree(), now()[0]}};
}

std::optional<Fingerprint> HeatRun::fingerprint() const {
    Fingerprint result;
    result.add("heat").add(space_).add(start_).add(options_.time_step).add(options_.scheme);
    return result.add(options_.linear_solver);
}

} // namespace polydec
