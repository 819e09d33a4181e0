// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace polydec {

/// The bytes as a raw deflate stream (RFC 1951), without the head and sum of zlib's: the same for
/// the same bytes. By zlib. Throws std::bad_alloc where memory ends.
std::string deflate(std::string_view bytes);

} // namespace polydec
