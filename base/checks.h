// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace polydec {

/// The end of a message about a number out of range: "expected 0 to 4", or "there are none" if the
/// range is empty.
std::string expected_numbers(std::int64_t least, std::int64_t most);

[[noreturn]] void refuse_number(std::string_view what, std::int64_t number, std::int64_t least,
                                std::int64_t most);

/// Throws InvalidInput, naming `what`, unless least <= number <= most: for degrees, cells and other
/// numbered items.
inline void check_number(std::string_view what, std::int64_t number, std::int64_t least,
                         std::int64_t most) {
    if (number < least || number > most)
        refuse_number(what, number, least, most);
}

/// Throw InvalidInput, naming `what`, unless the value is finite, and above 0 or at least 0.
void check_positive(std::string_view what, double value);
void check_not_negative(std::string_view what, double value);

[[noreturn]] void refuse_empty(std::string_view what);

/// Throws InvalidInput, naming `what`, if a std::function is empty.
template <class Function>
void check_callable(std::string_view what, const Function& function) {
    if (!function)
        refuse_empty(what);
}

/// Throws InvalidInput, naming `what`, unless the number of values given is the expected one.
void check_as_many(std::string_view what, std::int64_t given, std::int64_t expected);

/// The same, and for a value that is not finite.
void check_values(std::string_view what, const Vector& values, std::int64_t expected);

} // namespace polydec
