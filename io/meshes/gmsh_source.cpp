// SPDX-License-Identifier: MIT
#include "io/meshes/gmsh_source.h"

#include "io/byte_order.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace polydec {

namespace {

/// The number 1 shows in which order its bytes were written.
std::endian read_order(Scanner& scanner) {
    const auto one = scanner.bytes(4, "the number 1 as bytes");
    if (one == std::string_view("\1\0\0\0", 4))
        return std::endian::little;
    if (one == std::string_view("\0\0\0\1", 4))
        return std::endian::big;
    scanner.fail("the bytes after the version are not the number 1, which shows the order of "
                 "bytes; export it again");
}

} // namespace

GmshFormat read_gmsh_format(Scanner& scanner) {
    // It is a number that may be spelled as 2, 2.2 or 2.200000.
    const double version = scanner.number("a version");
    const double tenths = std::round(10 * version);
    const bool is_old = tenths >= 20 && tenths <= 22;
    if (std::abs(10 * version - tenths) > 1e-6 || !(is_old || tenths == 40 || tenths == 41))
        scanner.fail(fmt::format("MSH of version {}; expected 1, 2 to 2.2, 4.0 or 4.1; export it "
                                 "again with -format msh41",
                                 version));
    const auto encoding = scanner.integer("0 for text or 1 for bytes");
    const auto size = scanner.integer("the bytes of a number");
    const bool fits = (encoding == 0 || encoding == 1) && (size == 8 || (!is_old && size == 4));
    if (!fits)
        scanner.fail(fmt::format("file type {} and data size {}; expected 0 or 1, and {}; "
                                 "export it again",
                                 encoding, size, is_old ? "8" : "8 or 4"));
    scanner.end_line("the line of the version");
    GmshFormat format{is_old ? 2 : 4,
                      static_cast<int>(tenths) % 10,
                      {},
                      is_old ? 4 : static_cast<std::size_t>(size)};
    if (encoding == 1)
        format.order = read_order(scanner);
    return format;
}

std::int64_t GmshSource::whole_number(std::size_t bytes, std::string_view expected) {
    if (!format_.order)
        return scanner_.integer(expected);
    const char* place = scanner_.bytes(bytes, expected).data();
    return bytes == sizeof(std::int64_t) ? number_at<std::int64_t>(place, *format_.order)
                                         : number_at<std::int32_t>(place, *format_.order);
}

std::int64_t GmshSource::integer(std::string_view expected) {
    return whole_number(sizeof(std::int32_t), expected);
}

std::int64_t GmshSource::size(std::string_view expected) {
    return whole_number(format_.size_bytes, expected);
}

std::int64_t GmshSource::number(std::string_view expected) {
    return whole_number(format_.number_bytes(), expected);
}

std::size_t GmshSource::dimension() {
    const auto value = integer("the dimension of an entity");
    if (value < 0 || value > 3)
        fail(fmt::format("an entity of dimension {}; expected 0 to 3; export it again", value));
    return static_cast<std::size_t>(value);
}

double GmshSource::real(std::string_view expected) {
    if (!format_.order)
        return scanner_.number(expected);
    return number_at<double>(scanner_.bytes(sizeof(double), expected).data(), *format_.order);
}

Index GmshSource::count(std::string_view plural, const Record& record) {
    return check(size(fmt::format("the number of {}", plural)), plural, record);
}

Index GmshSource::count_on_line(std::string_view plural, const Record& record) {
    const Index count = check(scanner_.count(plural, 0), plural, record);
    scanner_.end_line("the line of their number");
    return count;
}

Index GmshSource::check(std::int64_t number, std::string_view plural, const Record& record) const {
    const auto words = record.integers + record.sizes + record.reals;
    const auto bytes = sizeof(std::int32_t) * record.integers + format_.size_bytes * record.sizes +
                       sizeof(double) * record.reals;
    return scanner_.as_count(number, plural, format_.order ? bytes : 2 * words);
}

void GmshSource::skip_integers(std::string_view plural) {
    const Index numbers = count(plural, {.integers = 1});
    for (Index i = 0; i < numbers; ++i)
        integer(plural);
}

void GmshSource::skip_reals(int count) {
    for (int i = 0; i < count; ++i)
        real("a number");
}

std::optional<std::int64_t> NumberTable::close() {
    if (!std::is_sorted(pairs_.begin(), pairs_.end()))
        std::sort(pairs_.begin(), pairs_.end());
    const auto twice =
        std::adjacent_find(pairs_.begin(), pairs_.end(),
                           [](const auto& a, const auto& b) { return a.first == b.first; });
    return twice == pairs_.end() ? std::nullopt : std::optional(twice->first);
}

std::optional<Index> NumberTable::find(std::int64_t number) const {
    // Mostly the numbers have no gaps, and then the place of one is known.
    auto found = pairs_.begin();
    if (!pairs_.empty() && number >= found->first) {
        const auto place =
            static_cast<std::uint64_t>(number) - static_cast<std::uint64_t>(found->first);
        if (place < pairs_.size() && pairs_[place].first == number)
            return pairs_[place].second;
    }
    found = std::lower_bound(pairs_.begin(), pairs_.end(), number,
                             [](const auto& pair, std::int64_t n) { return pair.first < n; });
    return found == pairs_.end() || found->first != number ? std::nullopt
                                                           : std::optional(found->second);
}

} // namespace polydec
