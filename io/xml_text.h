// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace polydec {

/// Text escaped for XML, between tags or quotes. Control characters, which XML forbids, become a
/// replacement character.
inline std::string xml_escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        switch (c) {
        case '&':
            result += "&amp;";
            break;
        case '<':
            result += "&lt;";
            break;
        case '>':
            result += "&gt;";
            break;
        case '"':
            result += "&quot;";
            break;
        default:
            const bool control = static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n';
            result += control ? std::string("\xEF\xBF\xBD") : std::string(1, c);
        }
    }
    return result;
}

} // namespace polydec
