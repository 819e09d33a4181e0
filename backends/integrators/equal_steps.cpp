// SPDX-License-Identifier: MIT
#include "backends/integrators/equal_steps.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polydec {

EqualSteps equal_steps(double from, double until, double wanted) {
    constexpr double rounding = std::numeric_limits<double>::epsilon();
    const double rest = until - from, nearest = std::round(rest / wanted);
    const double blur = 8 * rounding * std::max(std::abs(from), std::abs(until));
    if (nearest >= 1 && std::abs(nearest * wanted - rest) <= blur)
        return {wanted, nearest};
    const double count = std::max(1.0, std::ceil(rest / wanted));
    return {rest / count, count};
}

} // namespace polydec
