// SPDX-License-Identifier: MIT
#include "backends/linear/solution_quality.h"

#include <fmt/format.h>

#include <algorithm>

namespace polydec {

bool SolutionQuality::is_good(double wished) const {
    constexpr double residual_limit = 1e-6, backward_limit = 1e-10;
    return residual <= std::max(residual_limit, wished) &&
           backward_error <= std::max(backward_limit, wished);
}

// What no matrix hits is what a forgotten kernel leaves behind.
std::string SolutionQuality::failure() const {
    return fmt::format(
        "the solution is unreliable: |b - A x| / |b| = {:.2g}, backward error {:.2g}\n"
        "The matrix is singular to working precision, or its facts are wrong; if it has a kernel, "
        "give it in the facts.",
        residual, backward_error);
}

} // namespace polydec
