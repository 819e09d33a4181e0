// SPDX-License-Identifier: MIT
#include "shape/count_below.h"

#include "base/errors.h"
#include "shape/trusted_count.h"

#include <fmt/format.h>

#include <cmath>

namespace polydec {

CountBelow count_below(const Shape& shape, double s, const CountOptions& options) {
    check(shape);
    check_degree(options.degree);
    if (!std::isfinite(s))
        throw InvalidInput(fmt::format("eigenvalues below {}: expected a finite number", s));
    if (!(s > 0)) // the form is semidefinite
        return {.at_least = 0, .at_most = 0};
    const ConformingForm conforming(shape, options.degree);
    return enclosed_count(shape, conforming.family(), lower_form(shape, options.degree), s,
                          metric_ratio(shape), options.linear_solver);
}

} // namespace polydec
