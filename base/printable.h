// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace polydec {

/// The text as a terminal can show it, for messages: line breaks, control characters, marks that
/// turn the direction of writing and bytes that are no UTF-8 are escaped as \n, \t, \x1b, \u202e.
/// At most `longest` bytes and a sign that something was left out; the end is kept, which of a
/// path tells more.
std::string printable(std::string_view text, std::size_t longest = 200);

/// The same for a message, which may have several lines and is cut at its end.
std::string printable_message(std::string_view text, std::size_t longest = 600);

/// Whether the text is well-formed UTF-8.
bool is_utf8(std::string_view text);

} // namespace polydec
