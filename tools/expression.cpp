// SPDX-License-Identifier: MIT
#include "tools/expression.h"

#include "base/errors.h"
#include "dec/simplex_metric.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <muParser.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <vector>

namespace polydec::tools {

namespace {

constexpr int most_coordinates = 16;

[[noreturn]] void refuse(const std::string& option, const std::string& text,
                         const mu::Parser::exception_type& error) {
    throw CLI::ValidationError(
        option, fmt::format("'{}' is neither a file nor an expression: {}", text, error.GetMsg()));
}

/// The parser's own way goes through a stream, which takes a lack of memory for a wrong number.
int read_number(const char* text, int* position, double* value) {
    const bool begins_number = std::isdigit(static_cast<unsigned char>(*text)) != 0 || *text == '.';
    const auto [end, error] = std::from_chars(text, text + std::strlen(text), *value);
    if (!begins_number || error != std::errc())
        return 0;
    *position += static_cast<int>(end - text);
    return 1;
}

Vector read_values(const std::string& path, Index count) {
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    if (!file)
        throw IoError(fmt::format("{}: cannot be read", path));
    std::vector<double> values;
    const char* at = text.data();
    const char* const end = at + text.size();
    for (;;) {
        while (at != end && std::isspace(static_cast<unsigned char>(*at)))
            ++at;
        if (at == end)
            break;
        double value = 0;
        const auto [next, error] = std::from_chars(at, end, value);
        if (error != std::errc() || !std::isfinite(value))
            throw InvalidInput(fmt::format("{}: entry {} is no finite number: expected {} numbers "
                                           "separated by white space",
                                           path, values.size(), count));
        values.push_back(value);
        at = next;
    }
    if (values.size() != static_cast<std::size_t>(count))
        throw InvalidInput(fmt::format("{}: {} numbers, expected {}, one for each place", path,
                                       values.size(), count));
    return Eigen::Map<const Vector>(values.data(), count);
}

} // namespace

struct Expression::State {
    std::string option, text;
    mutable mu::Parser parser;
    mutable std::vector<double> position = std::vector<double>(most_coordinates, 0.0);
};

Expression::Expression(const std::string& option, const std::string& text)
    : state_(std::make_unique<State>()) {
    state_->option = option;
    state_->text = text;
    try {
        auto& parser = state_->parser;
        parser.DefineConst("pi", std::numbers::pi);
        const char* const names[] = {"x", "y", "z"};
        for (int i = 0; i < most_coordinates; ++i) {
            if (i < 3)
                parser.DefineVar(names[i], &state_->position[i]);
            parser.DefineVar(fmt::format("x{}", i + 1), &state_->position[i]);
        }
        parser.AddValIdent(read_number);
        parser.SetExpr(text);
        parser.Eval();
    } catch (const mu::Parser::exception_type& error) {
        refuse(option, text, error);
    }
}

Expression::~Expression() = default;

Vector Expression::operator()(const Points& sites) const {
    if (sites.cols() == 0 && !state_->parser.GetUsedVar().empty())
        require_points(0, fmt::format("{} {}", state_->option, state_->text));
    Vector values(sites.rows());
    for (Index i = 0; i < sites.rows(); ++i) {
        for (Index c = 0; c < std::min<Index>(static_cast<Index>(sites.cols()), most_coordinates);
             ++c)
            state_->position[c] = sites(i, c);
        try {
            values[i] = state_->parser.Eval();
        } catch (const mu::Parser::exception_type& error) {
            refuse(state_->option, state_->text, error);
        }
        if (!std::isfinite(values[i]))
            throw InvalidInput(fmt::format("{}: '{}' is {} at ({}): change the expression",
                                           state_->option, state_->text, values[i],
                                           fmt::join(sites.row(i), ", ")));
    }
    return values;
}

Vector values_at(const std::string& option, const std::string& text, const Points& sites) {
    std::error_code none;
    if (std::filesystem::is_regular_file(text, none))
        return read_values(text, static_cast<Index>(sites.rows()));
    return Expression(option, text)(sites);
}

} // namespace polydec::tools
