// SPDX-License-Identifier: MIT
#include "base/checks.h"
#include "base/errors.h"
#include "dec/fields/de_rham.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <utility>

namespace polydec {

Vector checked_value(const SmoothForm& form, const Vector& point, Index size, const char* what) {
    Vector value = form(point);
    if (value.size() != size)
        throw InvalidInput(fmt::format("the {} has {} coefficients at the point ({}): expected {}",
                                       what, value.size(), fmt::join(point, ", "), size));
    if (!value.allFinite())
        throw InvalidInput(fmt::format("the {} is not finite at the point ({}): the mesh must not "
                                       "touch a singularity",
                                       what, fmt::join(point, ", ")));
    return value;
}

SmoothForm function_form(std::function<double(const Vector& point)> function) {
    check_callable("the function of a form", function);
    return [f = std::move(function)](const Vector& point) {
        return Vector(Vector::Constant(1, f(point)));
    };
}

SmoothForm circulation_form(std::function<Vector(const Vector& point)> field) {
    check_callable("the vector field of a form", field);
    return [X = std::move(field)](const Vector& point) {
        return checked_value(X, point, static_cast<Index>(point.size()), "vector field");
    };
}

SmoothForm flux_form(std::function<Vector(const Vector& point)> field) {
    check_callable("the vector field of a form", field);
    return [X = std::move(field)](const Vector& point) {
        const auto N = static_cast<Index>(point.size());
        const Vector value = checked_value(X, point, N, "vector field");
        // the subset that omits the last axis comes first
        Vector coefficients(N);
        for (Index axis = 0; axis < N; ++axis)
            coefficients[N - 1 - axis] = (axis % 2 == 0 ? 1 : -1) * value[axis];
        return coefficients;
    };
}

} // namespace polydec
