// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>

namespace polydec {

/// The number stored at `place` in the given byte order.
template <typename Number>
Number number_at(const char* place, std::endian order) {
    std::array<char, sizeof(Number)> bytes;
    std::memcpy(bytes.data(), place, bytes.size());
    if (order != std::endian::native)
        std::reverse(bytes.begin(), bytes.end());
    return std::bit_cast<Number>(bytes);
}

} // namespace polydec
