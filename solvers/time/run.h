// SPDX-License-Identifier: MIT
#pragma once

#include "backends/integrator.h"
#include "dec/fingerprint.h"
#include "dec/forms/cochain.h"

#include <functional>
#include <optional>
#include <vector>

namespace polydec {

/// Is told of the time that a run has reached; what it throws ends a march behind the last good
/// step.
using TimeListener = std::function<void(double time)>;

/// A computation in time that can be interrupted, saved and resumed: an evolution, waves, a flow.
class Run {
public:
    virtual ~Run() = default;

    virtual double time() const = 0;

    /// Now, values that conditions fix included.
    virtual std::vector<Cochain> forms() const = 0;
    Cochain form(std::size_t number) const { return forms().at(number); }

    /// Marches to this time, or to the first event. Throws InvalidInput for a time before now;
    /// SolverFailure, naming the time, where values are not finite.
    virtual Arrival march(double until, const TimeListener& progress = {}) = 0;

    /// Everything that changes, apart from the time. A resumed run continues with the same steps,
    /// and with the same bits if its integrator can. Throws InvalidInput for a state of another
    /// run.
    virtual std::vector<Vector> state() const = 0;
    virtual void resume(double time, const std::vector<Vector>& state) = 0;

    /// Whether a state between two marches, whenever progress is told of, goes on to the same bits
    /// as well: steps then do not depend on the times that are marched to.
    virtual bool resumes_anywhere() const { return false; }

    /// By which the problem is known again: cells and all their stars, conditions, start,
    /// coefficients, steps, data, and the label. None of a run that calls functions and has no
    /// label, because what they compute cannot be compared.
    virtual std::optional<Fingerprint> fingerprint() const = 0;
};

} // namespace polydec
