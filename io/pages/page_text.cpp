// SPDX-License-Identifier: MIT
#include "io/pages/page_text.h"

#include "base/printable.h"
#include "io/number_text.h"
#include "io/xml_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace polydec {

namespace {

constexpr std::size_t longest_text = 20000;

} // namespace

std::string html_text(std::string_view text) {
    return xml_escaped(printable_message(text, longest_text));
}

std::string json_text(std::string_view text) {
    std::string result = "\"";
    for (const char c : printable_message(text, longest_text)) {
        const bool plain = static_cast<unsigned char>(c) >= 0x20 && c != '"' && c != '\\' &&
                           c != '<' && c != '>' && c != '&';
        result +=
            plain ? std::string(1, c) : fmt::format("\\u{:04x}", static_cast<unsigned char>(c));
    }
    return result + "\"";
}

std::string json_number(double value) {
    std::string text;
    append_number(text, value);
    return text;
}

std::string json_array(const std::vector<std::string>& values) {
    return fmt::format("[{}]", fmt::join(values, ","));
}

} // namespace polydec
