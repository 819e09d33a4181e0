// SPDX-License-Identifier: MIT
#include "base/printable.h"

#include <array>
#include <cstdint>
#include <cstdio>

namespace polydec {

namespace {

/// One character: its code point and how many bytes it takes; 0 bytes if there is no well-formed
/// one here.
struct Character {
    std::uint32_t code = 0;
    std::size_t bytes = 0;
};

Character character_at(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (byte(0) < 0x80)
        return {byte(0), 1};
    const std::size_t bytes = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
    if (byte(0) < 0xC2 || byte(0) > 0xF4 || text.size() < bytes)
        return {};
    std::uint32_t code = byte(0) & (0x7FU >> bytes);
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xC0U) != 0x80)
            return {};
        code = (code << 6U) | (byte(i) & 0x3FU);
    }
    // overlong forms, surrogates and what lies beyond Unicode
    constexpr std::array<std::uint32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
    const bool good = code >= least[bytes] && code <= 0x10FFFF && (code < 0xD800 || code > 0xDFFF);
    return good ? Character{code, bytes} : Character{};
}

bool is_shown(std::uint32_t code) {
    const auto within = [&](std::uint32_t first, std::uint32_t last) {
        return first <= code && code <= last;
    };
    // controls, marks of direction and of line ends, the mark of byte order
    return !(code < 0x20 || within(0x7F, 0x9F) || within(0x200B, 0x200F) ||
             within(0x2028, 0x202E) || within(0x2060, 0x206F) || code == 0xFEFF);
}

/// A character that is not shown, or a byte that is none.
std::string escaped(Character character, unsigned char byte) {
    switch (character.bytes == 1 ? byte : 0) {
    case '\n':
        return "\\n";
    case '\r':
        return "\\r";
    case '\t':
        return "\\t";
    default:
        break;
    }
    std::array<char, 16> text{};
    if (character.bytes > 1)
        std::snprintf(text.data(), text.size(), "\\u%04x", static_cast<unsigned>(character.code));
    else
        std::snprintf(text.data(), text.size(), "\\x%02x", static_cast<unsigned>(byte));
    return text.data();
}

/// Calls take(piece) for each character, escaped where it must be, until it says no.
template <class Take>
void for_each_piece(std::string_view text, bool keep_lines, Take take) {
    while (!text.empty()) {
        const Character character = character_at(text);
        const std::size_t bytes = character.bytes == 0 ? 1 : character.bytes;
        const bool kept =
            (keep_lines && text[0] == '\n') || (character.bytes > 0 && is_shown(character.code));
        if (!take(kept ? std::string(text.substr(0, bytes))
                       : escaped(character, static_cast<unsigned char>(text[0]))))
            return;
        text.remove_prefix(bytes);
    }
}

/// Where the last `longest` bytes begin, not within a character.
std::size_t tail(std::string_view text, std::size_t longest) {
    std::size_t begin = text.size() - longest;
    while (begin < text.size() && (static_cast<unsigned char>(text[begin]) & 0xC0U) == 0x80)
        ++begin;
    return begin;
}

} // namespace

std::string printable(std::string_view text, std::size_t longest) {
    // what is far longer than is shown needs no escaping
    if (text.size() > 4 * longest)
        text.remove_prefix(text.size() - 4 * longest);
    std::string result;
    for_each_piece(text, false, [&](const std::string& piece) {
        result += piece;
        return true;
    });
    if (result.size() > longest)
        result = "..." + result.substr(tail(result, longest));
    return result;
}

std::string printable_message(std::string_view text, std::size_t longest) {
    std::string result;
    for_each_piece(text, true, [&](const std::string& piece) {
        if (result.size() + piece.size() > longest) {
            result += " ..";
            return false;
        }
        result += piece;
        return true;
    });
    return result;
}

std::size_t bytes_of_character(std::string_view text) {
    return character_at(text).bytes;
}

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const auto bytes = bytes_of_character(text);
        if (bytes == 0)
            return false;
        text.remove_prefix(bytes);
    }
    return true;
}

} // namespace polydec
