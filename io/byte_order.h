// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <span>
#include <string>
#include <type_traits>

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

/// Numbers as bytes in the given order.
template <typename Number>
std::string bytes_of_all(std::span<const Number> numbers, std::endian order = std::endian::little) {
    std::string bytes(reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes());
    if (order != std::endian::native)
        for (auto place = bytes.begin(); place < bytes.end(); place += sizeof(Number))
            std::reverse(place, place + sizeof(Number));
    return bytes;
}

template <typename Number>
std::string bytes_of(Number number, std::endian order = std::endian::little) {
    static_assert(std::is_arithmetic_v<Number>);
    return bytes_of_all(std::span<const Number>(&number, 1), order);
}

} // namespace polydec
