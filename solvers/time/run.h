// SPDX-License-Identifier: MIT
#pragma once

#include "backends/integrator.h"
#include "base/progress.h"
#include "dec/discretization/fingerprint.h"
#include "dec/forms/cochain.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polydec {

/// Called with the time that a run has reached. An exception from it ends a march after the last
/// completed step.
using TimeListener = std::function<void(double time)>;

/// The steps of a march.
struct StepPlan {
    std::optional<std::int64_t> count = {}; ///< none: the steps are adaptive
    double length = 0;                      ///< the longest one, unless they are adaptive
    std::string limit = {};                 ///< what limits their length
    std::string advice = {};                ///< names the option that changes it
};

/// A computation in time that can be interrupted, saved and resumed: an evolution, waves, a flow.
class Run {
public:
    virtual ~Run() = default;

    virtual double time() const = 0;

    /// The forms at the current time, with values fixed by conditions.
    virtual std::vector<Cochain> forms() const = 0;
    Cochain form(std::size_t number) const { return forms().at(number); }

    /// Marches to this time, or to the first event. Throws InvalidInput for a time in the past or
    /// before the start; SolverFailure, naming the time, if values are not finite.
    virtual Arrival march(double until, const TimeListener& progress = {}) = 0;

    /// Reasons to doubt the results, known before the first step; none by default.
    virtual std::vector<std::string> warnings() const { return {}; }

    /// The steps that marches from now to these ascending times will take, if no event ends them.
    virtual StepPlan plan(const std::vector<double>& times) const = 0;

    /// Everything that changes, except the time. A resumed run continues with the same steps, and
    /// bit for bit if its integrator can. Throws InvalidInput for a state of another run.
    virtual std::vector<Vector> state() const = 0;
    virtual void resume(double time, const std::vector<Vector>& state) = 0;

    /// Whether a state saved between two marches, or at any progress report, also resumes bit for
    /// bit: steps then do not depend on the end times of marches.
    virtual bool resumes_anywhere() const { return false; }

    /// Identifies the problem: cells and all their stars, conditions, start, coefficients, steps,
    /// data, and the label. A run that calls functions and has no label has none, because functions
    /// cannot be compared.
    virtual std::optional<Fingerprint> fingerprint() const = 0;
};

/// A listener for marches of this run from now to these ascending times. It measures the first
/// steps; if more than ten seconds are left, it calls `announce` once, with a sentence about the
/// whole march: number and length of steps, what limits them, the estimated time, the memory that
/// the program has taken, and the option that changes the steps. Every call also calls `progress`.
TimeListener announcing(const Run& run, const std::vector<double>& times, Progress announce,
                        TimeListener progress = {});

} // namespace polydec
