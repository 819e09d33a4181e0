// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <type_traits>
#include <version>
#ifndef __cpp_lib_to_chars         // libc++ reads no doubles
#include <fast_float/fast_float.h> // Debian's libfast-float-dev
#endif

namespace polydec {

/// std::from_chars, also of doubles where the standard library has none. Without it, a number out
/// of range is infinite or zero, and no error.
template <class Number>
auto read_number(const char* first, const char* last, Number& value) {
#ifndef __cpp_lib_to_chars
    if constexpr (std::is_floating_point_v<Number>)
        return fast_float::from_chars(first, last, value);
    else
#endif
        return std::from_chars(first, last, value);
}

} // namespace polydec
