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
    const double f = metric_ratio(shape);
    const int n = shape.pieces.dimension();
    CountBelow result;
    const ConformingForm conforming(shape, options.degree);
    result.at_least =
        trusted_count(conforming.family(), s * f, Direction::down, options.linear_solver, n);
    const FormFamily lower = lower_form(shape, options.degree);
    const double above = s / f * (1 + 1e-15);
    if (!(above * (1 + 1e-6) < lower.limit())) {
        result.too_large = lower.beyond(above * (1 + 1e-6));
        result.warnings = {warning_of_large(shape, result.too_large, above, lower.limit())};
        return result;
    }
    result.at_most = trusted_count(lower, above, Direction::up, options.linear_solver, n);
    return result;
}

} // namespace polydec
