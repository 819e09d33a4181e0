// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace polydec {

/// Compresses bytes to a raw deflate stream (RFC 1951), without zlib's header and checksum.
/// Deterministic. Uses zlib. Throws std::bad_alloc if memory runs out.
std::string deflate(std::string_view bytes);

} // namespace polydec
