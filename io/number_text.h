// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <charconv>
#include <string>

namespace polydec {

/// Appends the shortest decimal text that reads back as the same number.
template <typename Number>
void append_number(std::string& text, Number number) {
    std::array<char, 32> digits;
    const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), number);
    text.append(digits.data(), result.ptr);
}

} // namespace polydec
