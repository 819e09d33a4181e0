// SPDX-License-Identifier: MIT
#include "solvers/heat.h"

#include "base/errors.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace polydec {

HeatSolver::HeatSolver(const Cells& cells, const BoundaryConditions& conditions, Side side,
                       int degree, const HeatOptions& options)
    : complex_(cells.complex()),
      diffusion_(cells, side, degree,
                 {.conditions = conditions, .linear_solver = options.linear_solver}) {
    if (!(options.time_step > 0) || !std::isfinite(options.time_step))
        throw InvalidInput(fmt::format("a time step of {} is given: expected a finite one above 0",
                                       options.time_step));
    const bool implicit = options.scheme == HeatScheme::backward_euler;
    const double implicit_part = implicit ? options.time_step : options.time_step / 2;
    explicit_part_ = options.time_step - implicit_part;
    diffusion_.prepare(implicit_part);
}

Cochain HeatSolver::step(const Cochain& form) const {
    check(complex_, form);
    const Side side = diffusion_.side();
    const int degree = diffusion_.degree();
    if (form.side != side || form.degree != degree)
        throw InvalidInput(fmt::format("a {} {}-form is given: this solver is for {} {}-forms",
                                       name(form.side), form.degree, name(side), degree));
    Vector result = Vector::Zero(form.values.size());
    result(diffusion_.kept()) = diffusion_.solve(form.values(diffusion_.kept()), explicit_part_);
    return {side, degree, std::move(result)};
}

HeatRun::HeatRun(const Cells& cells, const BoundaryConditions& conditions, const Cochain& start,
                 const HeatOptions& options)
    : FixedSteps(options.time_step, {start.values}),
      solver_(cells, conditions, start.side, start.degree, options),
      start_(start),
      problem_([=] {
          Fingerprint result;
          result.add("heat").add(cells).add(conditions).add(start.side).add(start.degree);
          result.add(start.values).add(options.time_step).add(options.scheme);
          return result.add(options.linear_solver);
      }) {}

void HeatRun::step(std::vector<Vector>& state) const {
    state[0] = solver_.step({start_.side, start_.degree, state[0]}).values;
}

std::vector<Cochain> HeatRun::forms() const {
    return {{start_.side, start_.degree, now()[0]}};
}

std::optional<Fingerprint> HeatRun::fingerprint() const {
    return problem_();
}

} // namespace polydec
