// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace polydec {

/// To how many bytes each byte of a zlib stream inflates at most.
inline constexpr std::size_t most_inflated_per_byte = 1032;

/// The bytes that a zlib stream (RFC 1950, 1951) holds; nothing if it is damaged, or if they are
/// not exactly `size`. Allocates no more than such a stream can hold.
/// By zlib.
std::optional<std::string> inflate(std::string_view stream, std::size_t size);

} // namespace polydec
