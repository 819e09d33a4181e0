// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace polydec {

/// The bytes that a zlib stream (RFC 1950, 1951) holds; nothing if it is damaged, or if they are
/// not exactly `size`. Allocates no more than such a stream can hold, about 1032 times its length.
/// By zlib.
std::optional<std::string> inflate(std::string_view stream, std::size_t size);

} // namespace polydec
