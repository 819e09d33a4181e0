// SPDX-License-Identifier: MIT
#pragma once

namespace polydec {

struct EqualSteps {
    double step, count;
};

/// The steps between two times: of the wanted length, where it fits but for the rounding of times,
/// else equal and shorter.
EqualSteps equal_steps(double from, double until, double wanted);

} // namespace polydec
