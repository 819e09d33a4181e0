// SPDX-License-Identifier: MIT
#pragma once

#include "base/printable.h"

#include <string>
#include <string_view>

namespace polydec {

/// Text escaped for XML, between tags or quotes. What XML forbids becomes a replacement character:
/// control characters, U+FFFE and U+FFFF, and bytes that are not UTF-8.
inline std::string xml_escaped(std::string_view text) {
    constexpr std::string_view replacement = "\xEF\xBF\xBD";
    std::string result;
    while (!text.empty()) {
        const std::size_t bytes = bytes_of_character(text);
        const std::string_view character = text.substr(0, bytes);
        const char c = text.front();
        const bool is_control = static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n';
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '"')
            result += "&quot;";
        else if (bytes == 0 || is_control || character == "\xEF\xBF\xBE" ||
                 character == "\xEF\xBF\xBF")
            result += replacement;
        else
            result += character;
        text.remove_prefix(bytes == 0 ? 1 : bytes);
    }
    return result;
}

} // namespace polydec
