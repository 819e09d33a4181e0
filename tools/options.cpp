// SPDX-License-Identifier: MIT
#include "tools/options.h"

#include "base/did_you_mean.h"
#include "base/printable.h"
#include "base/read_number.h"
#include "examples/paper/process.h"
#include "system/memory.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

namespace polydec::tools {

namespace {

/// All of the text as a finite number; none if it is not one.
template <class Number>
std::optional<Number> number_of(std::string_view text) {
    if (text.substr(0, 1) == "+" && text.substr(0, 2) != "+-")
        text.remove_prefix(1);
    Number value{};
    const auto [end, error] = read_number(text.data(), text.data() + text.size(), value);
    const bool good = error == std::errc() && end == text.data() + text.size();
    return good && std::isfinite(static_cast<double>(value)) ? std::optional(value) : std::nullopt;
}

std::string expected(std::string_view what, const std::string& text) {
    return text.empty() ? fmt::format("expected {}", what)
                        : fmt::format("expected {}, not '{}'", what, printable(text));
}

std::string check_text(const std::string& text) {
    return text.empty() ? "expected a value, not an empty text" : "";
}

/// Makes the text the plain decimal number that it is, since the parser of options would take a
/// leading zero for a sign of octal digits.
template <class Number>
CLI::Validator whole(const char* what) {
    const auto read = [what](std::string& text) {
        const auto value = number_of<Number>(text);
        if (!value)
            return expected(what, text);
        text = std::to_string(*value);
        return std::string();
    };
    return CLI::Validator(read, "");
}

std::string check_number(const std::string& text) {
    return number_of<double>(text) ? "" : expected("a number", text);
}

/// 500M, 1.5G, 800000000.
std::optional<double> bytes_of(const std::string& text) {
    constexpr std::string_view units = "kMGT";
    const auto unit = text.empty() ? std::string_view::npos : units.find(text.back());
    const bool has_unit = unit != std::string_view::npos;
    const auto value = number_of<double>(std::string_view(text).substr(0, text.size() - has_unit));
    if (!value)
        return std::nullopt;
    const double bytes = *value * std::pow(1000.0, has_unit ? static_cast<double>(unit) + 1 : 0);
    return bytes >= 1 && bytes < 1e18 ? std::optional(bytes) : std::nullopt;
}

std::string check_bytes(const std::string& text) {
    return bytes_of(text) ? "" : expected("an amount like 500M or 2G", text);
}

} // namespace

std::string check_not_negative(const std::string& text) {
    return number_of<double>(text).value_or(-1) >= 0 ? ""
                                                     : expected("a number of at least 0", text);
}

std::string check_positive(const std::string& text) {
    return number_of<double>(text).value_or(0) > 0 ? "" : expected("a number above 0", text);
}

CLI::Validator one_of(std::vector<std::string> names) {
    const auto check = [names = std::move(names)](std::string& text) {
        return std::find(names.begin(), names.end(), text) != names.end()
                   ? ""
                   : expected(fmt::format("{}", fmt::join(names, ", ")), text) +
                         did_you_mean(text, names);
    };
    return CLI::Validator(check, "");
}

CLI::Validator enumerator(std::vector<std::string> names) {
    const auto read = [names, check = one_of(names)](std::string& text) {
        const auto flaw = check(text);
        text = std::to_string(std::find(names.begin(), names.end(), text) - names.begin());
        return flaw;
    };
    return CLI::Validator(read, "");
}

std::optional<Vector> vector_of(std::string_view text) {
    std::vector<double> numbers;
    for (std::size_t begin = 0; begin <= text.size();) {
        const auto end = std::min(text.find(',', begin), text.size());
        const auto number = number_of<double>(text.substr(begin, end - begin));
        if (!number)
            return std::nullopt;
        numbers.push_back(*number);
        begin = end + 1;
    }
    return Eigen::Map<const Vector>(numbers.data(), std::ssize(numbers));
}

std::string check_vector(const std::string& text) {
    return vector_of(text) ? "" : expected("numbers with commas between, such as 1,0", text);
}

void add_common_options(CLI::App& command, TellOptions& options) {
    command.add_flag("--json", options.json, "print one JSON object instead of text");
    command
        .add_option_function<std::string>(
            "--max-memory",
            [](const std::string& text) {
                set_memory_limit(static_cast<std::uint64_t>(*bytes_of(text)));
                hold_memory_limit();
            },
            "SIZE\tfail rather than use more memory than SIZE, such as 500M (default: all)")
        ->check(check_bytes);
}

void expect_values(CLI::App& app) {
    for (auto* option : app.get_options()) {
        const auto type = option->get_type_name();
        if (type.rfind("INT", 0) == 0)
            option->transform(whole<int>("a whole number"));
        else if (type.rfind("UINT", 0) == 0)
            option->transform(whole<std::uint64_t>("a whole number of at least 0"));
        else if (type.rfind("FLOAT", 0) == 0 || type.rfind("[FLOAT", 0) == 0)
            option->check(check_number, "");
        else if (type.rfind("TEXT", 0) == 0)
            option->check(check_text, "");
    }
    for (auto* command : app.get_subcommands({}))
        expect_values(*command);
}

} // namespace polydec::tools
