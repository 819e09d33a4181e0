// SPDX-License-Identifier: MIT
#include "base/checks.h"
#include "base/errors.h"
#include "solvers/time/diffusion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace polydec {

namespace {

constexpr double most = 1e15; // steps

} // namespace

FixedSteps::FixedSteps(double time_step, std::vector<Vector> state)
    : time_step_(time_step), state_(std::move(state)) {
    check_positive("the time step", time_step);
}

void FixedSteps::advance(std::int64_t steps, const TimeListener& progress) {
    for (const std::int64_t last = steps_ + steps; steps_ < last;) {
        step(state_);
        ++steps_;
        if (progress)
            progress(time());
    }
    for (const Vector& values : state_)
        if (!values.allFinite())
            throw SolverFailure(fmt::format("after step {}, at time {:.6g}, values are not finite: "
                                            "use shorter steps, or check the data",
                                            steps_, time()));
}

std::int64_t FixedSteps::steps_to(double time, std::int64_t least) const {
    const double steps = std::round(time / time_step_);
    if (!(time >= 0 && steps >= static_cast<double>(least) && steps <= most))
        throw InvalidInput(
            fmt::format("there is no step to time {:.6g} from here: expected {:.6g} to {:.6g}",
                        time, static_cast<double>(least) * time_step_, most * time_step_));
    return static_cast<std::int64_t>(steps);
}

Arrival FixedSteps::march(double until, const TimeListener& progress) {
    advance(steps_to(until, steps_) - steps_, progress);
    return Arrival::at_time;
}

StepPlan FixedSteps::plan(const std::vector<double>& times) const {
    StepPlan result = limit();
    const double last = times.empty() ? 0 : std::round(times.back() / time_step_);
    result.count = static_cast<std::int64_t>(
        std::min(std::max(0.0, last - static_cast<double>(steps_)), most));
    result.length = time_step_;
    return result;
}

void FixedSteps::resume(double time, const std::vector<Vector>& state) {
    const std::int64_t steps = steps_to(time, 0);
    const auto exact = static_cast<double>(steps);
    const bool is_a_step = std::abs(time / time_step_ - exact) <= 1e-12 * std::max(1.0, exact);
    if (!is_a_step || !std::equal(state.begin(), state.end(), state_.begin(), state_.end(),
                                  [](const Vector& given, const Vector& own) {
                                      return given.size() == own.size() && given.allFinite();
                                  }))
        throw InvalidInput("the state belongs to another run: expected a state that state() of "
                           "this run returned, and its time");
    steps_ = steps;
    state_ = state;
}

} // namespace polydec
