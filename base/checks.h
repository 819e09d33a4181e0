// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

namespace polydec {

[[noreturn]] void refuse_number(std::string_view what, std::int64_t number, std::int64_t least,
                                std::int64_t most);

/// Throws InvalidInput, saying what it is, unless least <= number <= most: for degrees, cells and
/// whatever else is asked for by number.
inline void check_number(std::string_view what, std::int64_t number, std::int64_t least,
                         std::int64_t most) {
    if (number < least || number > most)
        refuse_number(what, number, least, most);
}

/// Throws InvalidInput, saying what it is, unless as many values are given as expected.
void check_as_many(std::string_view what, std::int64_t given, std::int64_t expected);

} // namespace polydec
