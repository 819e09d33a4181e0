// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace polydec {

/// The text in a form that a terminal can show, for messages: line breaks, control characters, bidi
/// marks and bytes that are not UTF-8 are escaped as \n, \t, \x1b, \u202e. At most `longest` bytes
/// plus a mark of omission; the end is kept, the more informative part of a path.
std::string printable(std::string_view text, std::size_t longest = 200);

/// The same for a message, which may have several lines and is cut at the end.
std::string printable_message(std::string_view text, std::size_t longest = 600);

/// The bytes of the first character; 0 if no well-formed UTF-8 begins the text, which is not empty.
std::size_t bytes_of_character(std::string_view text);

/// Whether the text is well-formed UTF-8.
bool is_utf8(std::string_view text);

} // namespace polydec
