// SPDX-License-Identifier: MIT
#include "base/checks.h"

#include "base/errors.h"

#include <fmt/format.h>

#include <cmath>

namespace polydec {

std::string expected_numbers(std::int64_t least, std::int64_t most) {
    return least > most ? "there are none" : fmt::format("expected {} to {}", least, most);
}

void refuse_number(std::string_view what, std::int64_t number, std::int64_t least,
                   std::int64_t most) {
    throw InvalidInput(
        fmt::format("{} {} is out of range: {}", what, number, expected_numbers(least, most)));
}

void check_positive(std::string_view what, double value) {
    if (!(value > 0) || !std::isfinite(value))
        throw InvalidInput(fmt::format("{} is {}: expected a finite number above 0", what, value));
}

void check_not_negative(std::string_view what, double value) {
    if (!(value >= 0) || !std::isfinite(value))
        throw InvalidInput(
            fmt::format("{} is {}: expected a finite number of at least 0", what, value));
}

void refuse_empty(std::string_view what) {
    throw InvalidInput(fmt::format("{} is empty: give a function", what));
}

void check_as_many(std::string_view what, std::int64_t given, std::int64_t expected) {
    if (given != expected)
        throw InvalidInput(fmt::format("{} {} are given: expected {}", given, what, expected));
}

void check_values(std::string_view what, const Vector& values, std::int64_t expected) {
    check_as_many(what, values.size(), expected);
    for (Eigen::Index i = 0; i < values.size(); ++i)
        if (!std::isfinite(values[i]))
            throw InvalidInput(
                fmt::format("{}: value {} is {}: expected finite numbers", what, i, values[i]));
}

} // namespace polydec
