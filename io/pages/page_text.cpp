// SPDX-License-Identifier: MIT
#include "io/pages/page_text.h"

#include "base/errors.h"
#include "base/printable.h"
#include "io/number_text.h"
#include "io/xml_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace polydec {

namespace {

constexpr std::size_t longest_text = 20000;
constexpr std::size_t most_bytes = 64 << 20;

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

std::string filled_page(std::string_view text,
                        const std::map<std::string_view, std::string>& parts) {
    std::string result;
    for (std::size_t at; (at = text.find("{{")) != std::string_view::npos;) {
        const auto end = text.find("}}", at);
        result += text.substr(0, at);
        result += parts.at(text.substr(at + 2, end - at - 2));
        text.remove_prefix(end + 2);
    }
    result += text;
    if (result.size() > most_bytes)
        throw InvalidInput(
            fmt::format("the page would need {} MB, more than the {} MB that browsers open well: "
                        "show fewer fields, or write a .vtu file",
                        result.size() >> 20, most_bytes >> 20));
    return result;
}

std::string json_array(const std::vector<std::string>& values) {
    return fmt::format("[{}]", fmt::join(values, ","));
}

} // namespace polydec
