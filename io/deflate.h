// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace polydec {

/// Compresses bytes to a raw deflate stream (RFC 1951), without zlib's header and checksum.
/// Deterministic. Uses zlib. Throws std::bad_alloc if memory runs out.
std::string deflate(std::string_view bytes);

/// The largest ratio of inflated bytes to bytes of a zlib stream.
inline constexpr std::size_t most_inflated_per_byte = 1032;

/// Decompresses a zlib stream (RFC 1950, 1951); none if it is damaged, or does not give exactly
/// `size` bytes. Allocates no more than such a stream can hold. Uses zlib.
std::optional<std::string> inflate(std::string_view stream, std::size_t size);

} // namespace polydec
