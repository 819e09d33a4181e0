// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "shape/family_counter.h"
#include "shape/one_forms.h"
#include "shape/shape_spectrum.h"

#include <fmt/format.h>

#include <cmath>

namespace polydec {

CountBelow count_below(const Shape& shape, double s, const CountOptions& options) {
    check(shape);
    check_level(options.level);
    if (!std::isfinite(s))
        throw InvalidInput(fmt::format("eigenvalues below {}: expected a finite number", s));
    if (!(s > 0)) // the form is semidefinite
        return {.at_least = 0, .at_most = 0};
    if (are_one_forms(shape, options.degree))
        return one_form_count(shape, s, options);
    const Shape of = options.degree == 0 ? shape : top_forms(shape);
    const ConformingForm conforming(of, options.level);
    const FormFamily lower = lower_form(of, options.level);
    FamilyCounter below(conforming.family(), options.linear_solver),
        above(lower, options.linear_solver);
    const double ratio = metric_ratio(of);
    CountBelow result;
    result.at_least = below.near(s * ratio, Direction::down);
    bound_above(result, of, above, s, ratio);
    return result;
}

} // namespace polydec
