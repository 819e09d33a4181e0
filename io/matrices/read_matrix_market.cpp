// SPDX-License-Identifier: MIT
#include "base/checks.h"
#include "io/matrices/matrix_market.h"
#include "io/matrices/parse_matrix_market.h"
#include "io/scanner.h"
#include "io/source_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace polydec {

namespace {

enum class MatrixSymmetry { general, symmetric, skew };

struct Entry {
    Index row;
    Index column;
    double value;
};

/// Reads the word of the first line that may be one of these; gives its place among them.
std::size_t choice(Scanner& scanner, const std::vector<std::string_view>& words) {
    std::string expected;
    for (const auto word : words)
        expected += std::string(expected.empty() ? "" : " or ") + std::string(word);
    const auto found = scanner.word(expected);
    const auto place = std::find(words.begin(), words.end(), found);
    if (place == words.end())
        scanner.fail(
            fmt::format("found {}; expected {}; convert the file", quote_word(found), expected));
    return static_cast<std::size_t>(place - words.begin());
}

/// Reads the first line, in which every word stands as the format defines it.
MatrixSymmetry read_banner(Scanner& scanner, std::string_view layout) {
    choice(scanner, {"%%MatrixMarket"});
    choice(scanner, {"matrix"});
    choice(scanner, {layout});
    choice(scanner, {"real", "integer", "double"});
    const auto symmetry = layout == "array"
                              ? choice(scanner, {"general"})
                              : choice(scanner, {"general", "symmetric", "skew-symmetric"});
    scanner.end_line("the first line");
    return static_cast<MatrixSymmetry>(symmetry);
}

/// The lines after the first, in which % begins a comment.
Scanner behind_banner(const Scanner& scanner) {
    Scanner body(scanner.name(), scanner.rest(), {.comment = '%'});
    body.set_line(scanner.line());
    return body;
}

double read_value(Scanner& scanner) {
    const double value = scanner.number("a number");
    if (!std::isfinite(value))
        scanner.fail("the entry is NaN, infinite or outside the range of double precision; "
                     "expected a finite number; correct the program that wrote it");
    return value;
}

Index read_size(Scanner& scanner, std::string_view what) {
    const auto size = scanner.integer(what);
    if (size < 0 || size > std::numeric_limits<Index>::max())
        scanner.fail(
            fmt::format("{1} is {0}; expected 0 to 2^31 - 1; correct the line", size, what));
    return static_cast<Index>(size);
}

Index read_place(Scanner& scanner, Index size, std::string_view what) {
    const auto place = scanner.integer(what);
    if (place < 1 || place > size)
        scanner.fail(fmt::format("{} {} is out of range; {}; correct the line", what, place,
                                 expected_numbers(1, size)));
    return static_cast<Index>(place - 1);
}

std::vector<Entry> read_entries(Scanner& scanner, Index rows, Index columns, Index count,
                                MatrixSymmetry symmetry) {
    std::vector<Entry> entries;
    entries.reserve(count);
    for (Index i = 0; i < count; ++i) {
        const Index row = read_place(scanner, rows, "row");
        const Index column = read_place(scanner, columns, "column");
        const double value = read_value(scanner);
        scanner.end_line("an entry of row, column and value");
        entries.push_back({row, column, value});
        if (symmetry != MatrixSymmetry::general && row != column)
            entries.push_back({column, row, symmetry == MatrixSymmetry::skew ? -value : value});
    }
    return entries;
}

void sort_and_check(std::vector<Entry>& entries, const Scanner& scanner) {
    const auto place = [](const Entry& entry) { return std::pair(entry.row, entry.column); };
    std::sort(entries.begin(), entries.end(),
              [place](const Entry& a, const Entry& b) { return place(a) < place(b); });
    const auto twice =
        std::adjacent_find(entries.begin(), entries.end(), [place](const Entry& a, const Entry& b) {
            return place(a) == place(b);
        });
    if (twice != entries.end())
        scanner.fail(fmt::format("the entry in row {} and column {} occurs twice; expected it "
                                 "once; add the two or remove one",
                                 twice->row + 1, twice->column + 1));
}

/// Few entries in very many rows would need memory that the size of the file does not justify.
void check_rows(const Scanner& scanner, Index rows) {
    constexpr std::size_t always_allowed = std::size_t{1} << 22;
    if (static_cast<std::size_t>(rows) > always_allowed + 16 * scanner.remaining())
        scanner.fail(fmt::format("{} rows, but {} bytes follow; expected fewer rows; correct the "
                                 "line",
                                 rows, scanner.remaining()));
}

SparseMatrix matrix_from(const std::vector<Entry>& entries, Index rows, Index columns) {
    SparseMatrix matrix(rows, columns);
    matrix.reserve(static_cast<Eigen::Index>(entries.size()));
    std::size_t next = 0;
    for (Index row = 0; row < rows; ++row) {
        matrix.startVec(row);
        for (; next < entries.size() && entries[next].row == row; ++next)
            matrix.insertBack(row, entries[next].column) = entries[next].value;
    }
    matrix.finalize();
    return matrix;
}

void expect_end(Scanner& scanner) {
    if (!scanner.at_end())
        scanner.fail("more entries follow than announced; expected the end of the file; correct "
                     "the number of entries");
}

} // namespace

SparseMatrix read_matrix_market(const std::filesystem::path& path) {
    return parse_matrix_market(read_source_file(path));
}

DenseMatrix read_matrix_market_array(const std::filesystem::path& path) {
    return parse_matrix_market_array(read_source_file(path));
}

SparseMatrix parse_matrix_market(const SourceFile& file) {
    Scanner banner(file.name, file.text);
    const auto symmetry = read_banner(banner, "coordinate");

    Scanner scanner = behind_banner(banner);
    const Index rows = read_size(scanner, "the number of rows");
    const Index columns = read_size(scanner, "the number of columns");
    const Index count = scanner.count("entries", 6);
    scanner.end_line("the line of sizes");
    check_rows(scanner, rows);
    if (symmetry != MatrixSymmetry::general && rows != columns)
        scanner.fail(fmt::format("a symmetric matrix of {} rows and {} columns; expected as many "
                                 "rows as columns; correct the line",
                                 rows, columns));

    auto entries = read_entries(scanner, rows, columns, count, symmetry);
    expect_end(scanner);
    sort_and_check(entries, scanner);
    return matrix_from(entries, rows, columns);
}

DenseMatrix parse_matrix_market_array(const SourceFile& file) {
    Scanner banner(file.name, file.text);
    read_banner(banner, "array");

    Scanner scanner = behind_banner(banner);
    const Index rows = read_size(scanner, "the number of rows");
    const Index columns = read_size(scanner, "the number of columns");
    scanner.end_line("the line of sizes");
    const auto promised = std::int64_t{rows} * columns;
    scanner.check_room(static_cast<std::uint64_t>(promised), "entries", 2);

    DenseMatrix matrix(rows, columns);
    for (double& entry : matrix.reshaped())
        entry = read_value(scanner);
    expect_end(scanner);
    return matrix;
}

} // namespace polydec
