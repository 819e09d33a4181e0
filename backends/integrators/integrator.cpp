// SPDX-License-Identifier: MIT
#include "backends/integrator.h"

#include "backends/integrators/equal_steps.h"
#include "base/checks.h"
#include "base/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace polydec {

namespace {

Eigen::Index first_not_finite(const Vector& values) {
    Eigen::Index i = 0;
    while (i < values.size() && std::isfinite(values[i]))
        ++i;
    return i;
}

/// The end of the smallest known interval in which a function of time crosses 0, as steps of this
/// length see it; 0: one step. A 0 at the beginning does not count.
template <class Event>
std::optional<double> first_crossing(const Event& event, double begin, double end, double length) {
    if (end == begin)
        return {};
    const auto [step, count] = equal_steps(begin, end, length > 0 ? length : end - begin);
    double before = event(begin);
    const auto is_behind = [&](double value) {
        return before != 0 && (value == 0 || (value > 0) != (before > 0));
    };
    for (double low = begin, left = count; left > 0; --left) {
        double high = left > 1 ? low + step : end;
        const double after = event(high);
        if (!is_behind(after)) {
            before = after;
            low = high;
            continue;
        }
        for (double middle = std::midpoint(low, high); low < middle && middle < high;
             middle = std::midpoint(low, high))
            (is_behind(event(middle)) ? high : low) = middle;
        return high;
    }
    return {};
}

} // namespace

Integrator::Integrator(const std::string& name, const IntegratorOptions& options)
    : options_(options) {
    report_.engine = name;
    check_not_negative(name + ": relative_tolerance", options.relative_tolerance);
    if (options.absolute_tolerance)
        check_positive(name + ": absolute_tolerance", *options.absolute_tolerance);
    else
        check_positive(name + ": without an absolute_tolerance, relative_tolerance",
                       options.relative_tolerance);
    check_not_negative(name + ": first_step", options.first_step);
    check_not_negative(name + ": largest_step", options.largest_step);
    check_not_negative(name + ": fixed_step", options.fixed_step);
    if (options.largest_step > 0 && options.first_step > options.largest_step)
        throw InvalidInput(fmt::format("{}: first_step is {}: expected at most largest_step, {}",
                                       name, options.first_step, options.largest_step));
    if (options.most_steps < 1)
        throw InvalidInput(
            fmt::format("{}: most_steps is {}: expected at least 1", name, options.most_steps));
}

void Integrator::check(const InitialValueProblem& problem, double time, const Vector& state) const {
    if (!problem.rate && !problem.stiff)
        throw InvalidInput(name() + ": the problem has neither a rate nor a stiff rate");
    if (problem.stiff && !(problem.stiff->rate && problem.stiff->prepare && problem.stiff->solve))
        throw InvalidInput(name() + ": the stiff part needs a rate, prepare and solve");
    if (!std::isfinite(time))
        throw InvalidInput(
            fmt::format("{}: the initial time is {}: expected a finite number", name(), time));
    if (const auto i = first_not_finite(state); i < state.size())
        throw InvalidInput(
            fmt::format("{}: entry {} of the initial state is {}: expected finite numbers", name(),
                        i, state[i]));
    if (problem.scale.size() != 0 &&
        (problem.scale.size() != state.size() || !problem.scale.allFinite() ||
         !(problem.scale.array() > 0).all()))
        throw InvalidInput(fmt::format("{}: expected a scale above 0 for each of the {} entries of "
                                       "the state, or none",
                                       name(), state.size()));
    if (const auto& parts = problem.parts; !parts.empty()) {
        const Index entries = std::accumulate(parts.begin(), parts.end(), Index{0});
        if (*std::min_element(parts.begin(), parts.end()) < 0 || entries != state.size())
            throw InvalidInput(fmt::format("{}: the parts have {} entries: expected numbers of at "
                                           "least 0 that add up to the {} entries of the state",
                                           name(), entries, state.size()));
    }
    if (options_.fixed_step > 0 && !traits().has_fixed_steps)
        throw InvalidInput(name() + ": chooses steps by the tolerances: omit "
                                    "IntegratorOptions::fixed_step");
}

void Integrator::begin(InitialValueProblem problem, double time, Vector state,
                       const Vector& memory) {
    check(problem, time, state);
    problem_ = std::move(problem);
    time_ = time;
    state_ = std::move(state);
    if (problem_.scale.size() == 0)
        problem_.scale = Vector::Ones(state_.size());
    if (problem_.parts.empty())
        problem_.parts = {static_cast<Index>(state_.size())};
    largest_ = Vector::Zero(static_cast<Eigen::Index>(problem_.parts.size()));
    largest_ = largest_with(state_);
    report_ = {.engine = report_.engine};
    has_begun_ = true;
    if (state_.size() > 0)
        start(memory);
}

Arrival Integrator::advance(double time) {
    if (!has_begun_)
        throw InvalidInput(name() + ": cannot advance before it begins");
    if (!std::isfinite(time) || time < time_)
        throw InvalidInput(
            fmt::format("{}: cannot advance from the time {} to {}", name(), time_, time));
    if (state_.size() > 0)
        return time == time_ ? Arrival::at_time : march(time);
    const auto value = [&](double t) { return has_events() ? event(t, state_) : 1; };
    const auto crossing =
        first_crossing(value, time_, time, std::max(options_.fixed_step, options_.largest_step));
    time_ = crossing.value_or(time);
    return crossing ? Arrival::at_event : Arrival::at_time;
}

Vector Integrator::sized(Vector rate, const char* what) const {
    if (rate.size() != state_.size())
        throw InvalidInput(fmt::format("{}: {} has {} entries; expected {}, as many as the state",
                                       name(), what, rate.size(), state_.size()));
    return rate;
}

Vector Integrator::rate(double time, const Vector& state) {
    ++report_.evaluations;
    if (problem_.progress)
        problem_.progress(time);
    return sized(problem_.rate(time, state), "the rate");
}

Vector Integrator::stiff_rate(double time, const Vector& state) {
    ++report_.stiff_evaluations;
    if (problem_.progress)
        problem_.progress(time);
    return sized(problem_.stiff->rate(time, state), "the stiff rate");
}

void Integrator::prepare(double time, const Vector& state, double gamma) {
    ++report_.preparations;
    problem_.stiff->prepare(time, state, gamma);
}

Vector Integrator::solve(const Vector& b) {
    ++report_.solves;
    if (problem_.progress)
        problem_.progress(time_);
    return sized(problem_.stiff->solve(b), "the solution of the stiff part");
}

Vector Integrator::ahead(double time, const Vector& state, double step) {
    Vector change = Vector::Zero(state.size());
    if (problem_.rate)
        change += step * rate(time + step, state);
    if (problem_.stiff)
        change += step * stiff_rate(time + step, state);
    if (problem_.stiff && change.allFinite())
        change = solve(change);
    return change.allFinite() ? state + change : state;
}

double Integrator::event(double time, const Vector& state) const {
    const double value = problem_.event(time, state);
    if (!std::isfinite(value))
        fail(fmt::format("the event function is {} at the time {:.17g}", value, time));
    return value;
}

void Integrator::accept(double time, Vector state, double step) {
    time_ = time;
    state_ = std::move(state);
    largest_ = largest_with(state_);
    report_.last_step = step;
    ++report_.steps;
}

Vector Integrator::largest_with(const Vector& state) const {
    Vector result = largest_;
    Eigen::Index first = 0, part = 0;
    for (const Index entries : problem_.parts) {
        const auto coefficients =
            state.segment(first, entries).cwiseQuotient(problem_.scale.segment(first, entries));
        result[part] = std::max(result[part], coefficients.lpNorm<Eigen::Infinity>());
        first += entries;
        ++part;
    }
    return result;
}

Vector Integrator::allowed(const Vector& state, const Vector& largest) const {
    Vector result = options_.relative_tolerance * state.cwiseAbs();
    Eigen::Index first = 0, part = 0;
    for (const Index entries : problem_.parts) {
        const double size = largest[part] > 0 ? largest[part] : largest.maxCoeff();
        const double absolute =
            options_.absolute_tolerance.value_or(1e-3 * options_.relative_tolerance * size);
        result.segment(first, entries) += absolute * problem_.scale.segment(first, entries);
        first += entries;
        ++part;
    }
    return result.cwiseMax(std::numeric_limits<double>::min()); // errors of 0 are allowed
}

double Integrator::size(const Vector& error, const Vector& allowed) const {
    return std::sqrt((error.array() / allowed.array()).square().mean());
}

void Integrator::fail(const std::string& reason) const {
    throw SolverFailure(fmt::format("{}: after {} steps, at the time {:.10g}: {}", name(),
                                    report_.steps, time_, reason),
                        SolveReport::failed(name(), report_.steps));
}

void Integrator::fail_of_rate() {
    const auto look = [&](const char* what, const Vector& rate) {
        if (const auto i = first_not_finite(rate); i < rate.size())
            fail(fmt::format("entry {} of {} is {}: expected finite numbers", i, what, rate[i]));
    };
    if (problem_.rate)
        look("the rate", rate(time_, state_));
    if (problem_.stiff)
        look("the stiff rate", stiff_rate(time_, state_));
    fail("a rate is not finite, even for the shortest step: the solution may end here");
}

} // namespace polydec
