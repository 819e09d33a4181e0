// SPDX-License-Identifier: MIT
#pragma once

#include "solvers/time/run.h"

namespace polydec {

/// A run with fixed steps from time 0. A march to a time ends after the step that is nearest to it.
class FixedSteps : public Run {
public:
    double time() const final { return static_cast<double>(steps_) * time_step_; }
    double time_step() const { return time_step_; }

    /// Takes this many steps. Throws like march.
    void advance(std::int64_t steps = 1, const TimeListener& progress = {});

    Arrival march(double until, const TimeListener& progress = {}) final;
    StepPlan plan(const std::vector<double>& times) const final;
    std::vector<Vector> state() const final { return state_; }
    void resume(double time, const std::vector<Vector>& state) final;
    bool resumes_anywhere() const final { return true; }

protected:
    /// Throws InvalidInput unless the step is finite and above 0.
    FixedSteps(double time_step, std::vector<Vector> state);

    /// Advances a state at time() by one step. If it throws, the state is unchanged.
    virtual void step(std::vector<Vector>& state) const = 0;

    /// The limit and the advice of the plan.
    virtual StepPlan limit() const = 0;

    const std::vector<Vector>& now() const { return state_; }

private:
    double time_step_;
    std::int64_t steps_ = 0;
    std::vector<Vector> state_;
};

} // namespace polydec
