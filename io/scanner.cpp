// SPDX-License-Identifier: MIT
#include "io/scanner.h"

#include "base/checks.h"
#include "base/errors.h"
#include "base/read_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace polydec {

namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// The place of the first digit that is not zero: positive in front of the decimal point.
/// Tells a number too large for a double from one too small, where the parser says only "range".
double decimal_exponent(std::string_view number) {
    const auto exponent_mark = std::min(number.find_first_of("eE"), number.size());
    const auto mantissa = number.substr(0, exponent_mark);
    const auto point = std::min(mantissa.find('.'), mantissa.size());
    const auto digit = std::min(mantissa.find_first_of("123456789"), mantissa.size());
    double exponent = static_cast<double>(point) - static_cast<double>(digit);

    if (exponent_mark < number.size()) {
        auto tail = number.substr(exponent_mark + 1);
        const bool negative = !tail.empty() && tail[0] == '-';
        tail.remove_prefix(!tail.empty() && (tail[0] == '-' || tail[0] == '+') ? 1 : 0);
        std::uint32_t shift = 0;
        const auto result = std::from_chars(tail.data(), tail.data() + tail.size(), shift);
        const double size = result.ec == std::errc{} ? shift : 1e12;
        exponent += negative ? -size : size;
    }
    return exponent;
}

double out_of_range_value(std::string_view number) {
    const double size =
        decimal_exponent(number) < 0 ? 0.0 : std::numeric_limits<double>::infinity();
    return number[0] == '-' ? -size : size;
}

} // namespace

Scanner::Scanner(std::string_view name, std::string_view text, Syntax syntax)
    : name_(name), position_(text.data()), end_(text.data() + text.size()), syntax_(syntax) {
    if (text.substr(0, byte_order_mark.size()) == byte_order_mark)
        position_ += byte_order_mark.size();
}

bool Scanner::at_end() {
    while (at_line_end()) {
        if (position_ == end_)
            return true;
        skip_line_break();
    }
    return false;
}

bool Scanner::at_line_end() {
    skip_blanks();
    if (position_ != end_ && *position_ == syntax_.comment && syntax_.comment != '\0')
        position_ = std::find_if(position_, end_, [this](char c) { return is_line_break(c); });
    return position_ == end_ || is_line_break(*position_);
}

void Scanner::next_line() {
    while (position_ != end_ && !is_line_break(*position_))
        if (continues_at(position_++))
            skip_line_break();
    skip_line_break();
}

std::string_view Scanner::word(std::string_view expected) {
    go_to_word(expected);
    const auto found = word_here();
    position_ += found.size();
    return found;
}

double Scanner::number(std::string_view expected) {
    go_to_word(expected);
    const bool plus = *position_ == '+' && end_ - position_ > 1 && position_[1] != '-';
    const char* first = position_ + (plus ? 1 : 0);

    double value = 0.0;
    const auto [last, error] = read_number(first, end_, value);
    if (error != std::errc::invalid_argument && last != end_ && (*last == 'D' || *last == 'd'))
        return fortran_number(expected);
    if (error == std::errc::invalid_argument || !ends_word(last))
        fail_at_word("is not a number", expected);
    if (error == std::errc::result_out_of_range)
        value = out_of_range_value({first, static_cast<std::size_t>(last - first)});
    position_ = last;
    return value;
}

/// Fortran writes the exponent of a double behind a D.
double Scanner::fortran_number(std::string_view expected) {
    std::string text(word_here());
    text[text.find_first_of("Dd")] = 'e';
    if (text.find_first_of("Dd") != std::string::npos)
        fail_at_word("is not a number", expected);
    Scanner other(name_, text);
    other.set_line(line_);
    const double value = other.number(expected);
    position_ += text.size();
    return value;
}

std::int64_t Scanner::integer(std::string_view expected, char end_mark) {
    go_to_word(expected);
    const bool plus = *position_ == '+' && end_ - position_ > 1 && position_[1] != '-';

    std::int64_t value = 0;
    const auto [last, error] = std::from_chars(position_ + (plus ? 1 : 0), end_, value);
    const bool marked = end_mark != '\0' && last != end_ && *last == end_mark;
    if (error == std::errc::invalid_argument || !(marked || ends_word(last)))
        fail_at_word("is not a whole number", expected);
    if (error == std::errc::result_out_of_range)
        fail_at_word("is too large", expected);
    position_ = last;
    return value;
}

double Scanner::coordinate(Index vertex) {
    return as_coordinate(number("a coordinate"), vertex);
}

Index Scanner::count(std::string_view plural, std::size_t least_bytes) {
    return as_count(integer(fmt::format("the number of {}", plural)), plural, least_bytes);
}

double Scanner::as_coordinate(double value, Index vertex) const {
    if (!std::isfinite(value))
        fail(fmt::format(
            "vertex {} (counted from 0) has a coordinate that is NaN, infinite or outside the "
            "range of double precision; expected finite numbers; repair or remove the vertex",
            vertex));
    return value;
}

Index Scanner::as_count(std::int64_t value, std::string_view plural,
                        std::size_t least_bytes) const {
    if (value < 0)
        fail(fmt::format("{} {} are announced; expected a number of at least 0; correct it", value,
                         plural));
    if (least_bytes > 0)
        check_room(static_cast<std::uint64_t>(value), plural, least_bytes);
    if (value > std::numeric_limits<Index>::max())
        fail(fmt::format("more than 2^31 - 1 {}; expected fewer; divide the mesh", plural));
    return static_cast<Index>(value);
}

/// The last record needs no separator behind it, hence the one byte more.
void Scanner::check_room(std::uint64_t count, std::string_view plural,
                         std::size_t least_bytes) const {
    if (count > (bytes_to_come() + 1) / least_bytes)
        fail(fmt::format("{} {} are announced, but {} bytes follow; expected at least {} bytes for "
                         "each; correct the number, or export again if the file was cut off",
                         count, plural, bytes_to_come(), least_bytes));
}

Index Scanner::vertex(Index vertices, Index first) {
    const auto value = integer("a vertex number");
    if (value < first || value - first >= vertices)
        fail(
            fmt::format("vertex number {} is out of range; {}; correct the index or add the vertex",
                        value, expected_numbers(first, std::int64_t{vertices} - 1 + first)));
    return static_cast<Index>(value - first);
}

std::string_view Scanner::bytes(std::size_t count, std::string_view expected) {
    if (count > remaining())
        fail(fmt::format("the file ends here; expected {}; export it again, it seems cut off",
                         expected));
    const std::string_view result(position_, count);
    line_ += std::count(result.begin(), result.end(), '\n');
    position_ += count;
    return result;
}

void Scanner::stay_on_line(std::string_view record) {
    if (at_line_end())
        fail(fmt::format("the line ends here; expected {}; complete the line", record));
}

void Scanner::end_line(std::string_view record) {
    if (!at_line_end())
        fail_at_word("follows on the same line", fmt::format("the end of {}", record));
    next_line();
}

void Scanner::fail(const std::string& text) const {
    throw InvalidInput(fmt::format("{}:{}: {}", name_, line_, text),
                       {.path = name_, .line = static_cast<std::int64_t>(line_)});
}

/// A continuation mark counts only directly in front of a line break.
bool Scanner::continues_at(const char* place) const {
    return syntax_.continuation != '\0' && *place == syntax_.continuation && end_ - place > 1 &&
           is_line_break(place[1]);
}

bool Scanner::ends_word(const char* place) const {
    return place == end_ || is_space(*place) || continues_at(place);
}

void Scanner::go_to_word(std::string_view expected) {
    if (at_end())
        fail(fmt::format("the file ends here; expected {}; export it again, it seems cut off",
                         expected));
}

void Scanner::skip_blanks() {
    while (position_ != end_ && !is_line_break(*position_) &&
           (is_space(*position_) || continues_at(position_)))
        if (continues_at(position_++))
            skip_line_break();
}

void Scanner::skip_line_break() {
    if (position_ == end_)
        return;
    const bool two = *position_ == '\r' && end_ - position_ > 1 && position_[1] == '\n';
    position_ += two ? 2 : 1;
    ++line_;
}

std::string_view Scanner::word_here() const {
    const char* last = position_;
    while (!ends_word(last))
        ++last;
    return {position_, static_cast<std::size_t>(last - position_)};
}

void Scanner::fail_at_word(std::string_view problem, std::string_view expected) const {
    fail(fmt::format("{} {}; expected {}; correct the line or export the file again",
                     quote_word(word_here()), problem, expected));
}

std::string quote_word(std::string_view word) {
    constexpr std::size_t longest = 40;
    std::string text(word.substr(0, longest));
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return "'" + text + (word.size() > longest ? "...'" : "'");
}

} // namespace polydec
