// SPDX-License-Identifier: MIT
#include "solvers/time/time_steps.h"

#include "base/checks.h"
#include "base/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace polydec {

TimeSteps time_steps(double time, double longest, Index multiple) {
    constexpr double most = 1e9, rounding = 1e-9;
    check_not_negative("the time", time);
    if (!(longest > 0))
        throw InvalidInput(
            fmt::format("the longest time step is {}: expected a number above 0", longest));
    const double count = multiple * std::max(1.0, std::ceil(time / longest / multiple - rounding));
    if (!(count <= most))
        throw InvalidInput(fmt::format("{:.3g} steps of {:.3g} are too many: expected at most "
                                       "{:.0g}; use longer steps or an earlier end",
                                       count, longest, most));
    return {static_cast<Index>(count), time / count};
}

} // namespace polydec
