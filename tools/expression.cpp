// SPDX-License-Identifier: MIT
#include "tools/expression.h"

#include "base/errors.h"
#include "base/printable.h"
#include "base/read_number.h"
#include "dec/metric/simplex_metric.h"
#include "io/source_file.h"
#include "tools/expression_syntax.h"
#include "tools/outputs.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <muParser.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <numbers>
#include <system_error>
#include <vector>

namespace polydec::tools {

namespace {

constexpr int most_coordinates = 64;

[[noreturn]] void refuse(const std::string& option, const std::string& text,
                         const std::string& reason) {
    throw CLI::ValidationError(option, fmt::format("'{}' is neither a file nor an expression: {}",
                                                   printable(text), printable_message(reason)));
}

/// The parser's message, which counts positions from 0 and may name the one behind its own space.
std::string counted_from_1(std::string message, std::size_t text_size, int position) {
    const std::string own = fmt::format("position {}", position);
    if (const auto at = message.find(own); at != std::string::npos)
        message.replace(
            at, own.size(),
            fmt::format("position {}", std::min(position + 1, static_cast<int>(text_size) + 1)));
    return message;
}

/// The parser's own way goes through a stream, which takes a lack of memory for a wrong number.
int recognize_number(const char* text, int* position, double* value) {
    const bool begins_number = std::isdigit(static_cast<unsigned char>(*text)) != 0 || *text == '.';
    const auto [end, error] = read_number(text, text + std::strlen(text), *value);
    if (!begins_number || error != std::errc())
        return 0;
    *position += static_cast<int>(end - text);
    return 1;
}

std::vector<double> read_numbers(const std::string& path) {
    const std::string text = read_source_file(path).text;
    std::vector<double> values;
    const char* at = text.data();
    const char* const end = at + text.size();
    for (;;) {
        while (at != end && std::isspace(static_cast<unsigned char>(*at)))
            ++at;
        if (at == end)
            return values;
        double value = 0;
        const auto [next, error] = read_number(at, end, value);
        const bool ends = next == end || std::isspace(static_cast<unsigned char>(*next));
        if (error != std::errc() || !ends || !std::isfinite(value))
            throw InvalidInput(fmt::format("{}: entry {} is not a finite number: expected numbers "
                                           "separated by white space, one per site",
                                           printable(path), values.size()));
        values.push_back(value);
        at = next;
    }
}

} // namespace

struct Expression::State {
    std::string option, text, label;
    mu::Parser parser;
    std::array<double, most_coordinates> position{};
    int used = 0; ///< the coordinates up to this one
    double label_value = 0;
    bool uses_label = false;

    /// At the values that the variables have; place() names them in the error if it is undefined.
    template <class Place>
    double value(Place place) const {
        double result = 0;
        try {
            result = parser.Eval();
        } catch (const mu::Parser::exception_type& error) {
            refuse(option, text, error.GetMsg());
        }
        if (!std::isfinite(result))
            throw InvalidInput(fmt::format("{}: '{}' is {} at {}: change the expression", option,
                                           printable(text), result, place()));
        return result;
    }
};

Expression::Expression(const std::string& option, const std::string& text, const std::string& label)
    : state_(std::make_unique<State>()) {
    state_->option = option;
    state_->text = text;
    state_->label = label;
    if (const auto flaw = misread_syntax(text); !flaw.empty())
        refuse(option, text, flaw);
    try {
        auto& parser = state_->parser;
        // which would change the order of operations
        parser.EnableOptimizer(false);
        parser.ClearConst(); // with names and digits of its own
        parser.DefineConst("pi", std::numbers::pi);
        constexpr std::array names{"x", "y", "z"};
        for (std::size_t i = 0; i < state_->position.size(); ++i) {
            if (i < names.size())
                parser.DefineVar(names[i], &state_->position[i]);
            parser.DefineVar(fmt::format("x{}", i + 1), &state_->position[i]);
        }
        if (!label.empty())
            parser.DefineVar(label, &state_->label_value);
        parser.AddValIdent(recognize_number);
        parser.SetExpr(text);
        parser.Eval();
        for (const auto& [name, place] : parser.GetUsedVar())
            if (place == &state_->label_value)
                state_->uses_label = true;
            else
                state_->used =
                    std::max(state_->used, static_cast<int>(place - state_->position.data()) + 1);
    } catch (const mu::Parser::exception_type& error) {
        refuse(option, text,
               counted_from_1(error.GetMsg(), text.size(), static_cast<int>(error.GetPos())));
    }
}

Expression::~Expression() = default;

bool Expression::uses_label() const {
    return state_->uses_label;
}

Vector Expression::operator()(const Points& sites, const Vector& labels) const {
    auto& [option, text, label, parser, position, used, label_value, uses_label] = *state_;
    if (uses_label && labels.size() == 0)
        throw InvalidInput(
            fmt::format("{}: '{}' uses `{}`, but the mesh has none: give a mesh with "
                        "physical groups, or change the expression",
                        option, printable(text), label));
    const auto axes = static_cast<int>(sites.cols());
    if (axes == 0 && used > 0)
        require_points(0, fmt::format("{} {}", option, printable(text)));
    if (used > axes)
        throw InvalidInput(fmt::format("{}: '{}' uses coordinate {}, but the mesh has {}: change "
                                       "the expression",
                                       option, printable(text), used, axes));
    Vector values(sites.rows());
    for (Index i = 0; i < sites.rows(); ++i) {
        for (int c = 0; c < used; ++c)
            position[c] = sites(i, c);
        if (uses_label)
            label_value = labels[labels.size() > 1 ? i : 0];
        values[i] =
            state_->value([&] { return fmt::format("({})", fmt::join(sites.row(i), ", ")); });
    }
    return values;
}

double Expression::of_label(double label) const {
    if (state_->used > 0)
        throw InvalidInput(fmt::format("{}: '{}' depends on x, y or z: expected an expression only "
                                       "in {}",
                                       state_->option, printable(state_->text), state_->label));
    state_->label_value = label;
    return state_->value([&] { return fmt::format("{} = {}", state_->label, label); });
}

SiteValues::SiteValues(const std::string& option, const std::string& text,
                       const std::string& label) {
    std::error_code none;
    if (!std::filesystem::is_regular_file(text, none)) {
        expression_ = std::make_unique<Expression>(option, text, label);
        return;
    }
    file_ = text;
    note_input(text);
    try {
        const Expression also(option, text, label);
    } catch (const CLI::ValidationError&) {
        const auto numbers = read_numbers(text);
        values_ = Eigen::Map<const Vector>(numbers.data(), static_cast<Index>(numbers.size()));
        return;
    }
    throw CLI::ValidationError(
        option, fmt::format("'{0}' is both an expression and a file: write ({0}) or ./{0}",
                            printable(text)));
}

Vector SiteValues::at(const Points& sites, const Vector& labels) const {
    if (expression_)
        return (*expression_)(sites, labels);
    check_count(sites.rows());
    return values_;
}

Vector SiteValues::at(const Points& sites, const std::vector<std::int64_t>& numbers,
                      std::int64_t count) const {
    if (expression_)
        return (*expression_)(sites);
    check_count(count);
    Vector result(sites.rows());
    for (std::size_t i = 0; i < numbers.size(); ++i)
        result[static_cast<Index>(i)] = values_[numbers[i]];
    return result;
}

void SiteValues::check_count(std::int64_t places) const {
    if (values_.size() != places)
        throw InvalidInput(fmt::format("{}: {} numbers, expected {}, one per site",
                                       printable(file_), values_.size(), places));
}

} // namespace polydec::tools
