// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

namespace polydec {

/// Equal steps; the last one ends at the requested time.
struct TimeSteps {
    Index count;
    double length;
};

/// The fewest steps of at most the length `longest`, up to rounding, to a time, in number a
/// multiple of `multiple`. Throws InvalidInput for a time that is negative or not finite, a length
/// that is not above 0, and more than 1e9 steps.
TimeSteps time_steps(double time, double longest, Index multiple = 1);

} // namespace polydec
