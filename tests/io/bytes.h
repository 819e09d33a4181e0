// SPDX-License-Identifier: MIT
#pragma once

#include "io/base64.h"
#include "tests/support/test.h"

namespace polydec::test {

/// The bytes of a number in an order.
template <typename Number>
std::string bytes_of(Number number, std::endian order) {
    std::string bytes(sizeof(Number), '\0');
    std::memcpy(bytes.data(), &number, sizeof(Number));
    if (order != std::endian::native)
        std::reverse(bytes.begin(), bytes.end());
    return bytes;
}

/// The bytes of numbers one after the other, each as a `Number`.
template <typename Number, typename Numbers>
std::string bytes_of_all(const Numbers& numbers, std::endian order) {
    std::string bytes;
    for (const auto number : numbers)
        bytes += bytes_of(static_cast<Number>(number), order);
    return bytes;
}

/// Bytes written as hexadecimal digits.
inline std::string from_hex(std::string_view digits) {
    const auto value = [](char c) { return c <= '9' ? c - '0' : c - 'a' + 10; };
    std::string bytes;
    for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
        bytes += static_cast<char>(16 * value(digits[i]) + value(digits[i + 1]));
    return bytes;
}

/// Bytes as base64 text.
inline std::string base64(const std::string& bytes) {
    std::string text;
    Base64Writer writer([&text](std::string_view piece) { text += piece; });
    for (const char byte : bytes)
        writer.write(byte);
    writer.finish();
    return text;
}

} // namespace polydec::test
