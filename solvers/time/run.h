// SPDX-License-Identifier: MIT
#pragma once

#include "backends/integrator.h"
#include "dec/fingerprint.h"
#include "dec/forms/cochain.h"

#include <functional>
#include <optional>
#include <vector>

namespace polydec {

/// Called with the time that a run has reached. An exception from it ends a march after the last
/// completed step.
using TimeListener = std::function<void(double time)>;

/// A computation in time that can be interrupted, saved and resumed: an evolution, waves, a flow.
class Run {
public:
    virtual ~Run() = default;

    virtual double time() const = 0;

    /// The forms at the current time, with values fixed by conditions.
    virtual std::vector<Cochain> forms() const = 0;
    Cochain form(std::size_t number) const { return forms().at(number); }

    /// Marches to this time, or to the first event. Throws InvalidInput for a time in the past;
    /// SolverFailure, naming the time, if values are not finite.
    virtual Arrival march(double until, const TimeListener& progress = {}) = 0;

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

} // namespace polydec
