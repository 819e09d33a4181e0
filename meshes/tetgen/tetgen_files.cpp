// SPDX-License-Identifier: MIT
#include "meshes/tetgen/tetgen_files.h"

#include "base/errors.h"
#include "base/lists.h"
#include "base/read_number.h"
#include "system/regular_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <limits>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

namespace polydec {

namespace {

void append_places(fmt::memory_buffer& text, const Points& places) {
    for (Eigen::Index i = 0; i < places.rows(); ++i)
        fmt::format_to(std::back_inserter(text), "{} {} {} {}\n", i, places(i, 0), places(i, 1),
                       places(i, 2));
}

/// The numbers of a file, one after the other.
class Numbers {
public:
    explicit Numbers(const std::filesystem::path& path)
        : name_(path.filename().string()), text_(read_regular_file(path)) {}

    template <typename Number>
    Number next() {
        constexpr std::string_view blanks = " \t\r\n";
        at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size());
        Number number{};
        const char* const begin = text_.data() + at_;
        const auto [end, error] = read_number(begin, text_.data() + text_.size(), number);
        if (error != std::errc())
            malformed(fmt::format("a number is missing after {} bytes", at_));
        at_ += static_cast<std::size_t>(end - begin);
        return number;
    }

    /// A count of rows of at least `width` numbers each, which must have room in the file.
    Index count(std::size_t width) {
        const auto rows = next<long long>();
        const auto most =
            std::min<std::size_t>(text_.size() / (2 * width), std::numeric_limits<Index>::max());
        if (rows < 0 || std::cmp_greater(rows, most))
            malformed(fmt::format("it announces {} rows, but has {} bytes", rows, text_.size()));
        return static_cast<Index>(rows);
    }

    /// How many numbers follow in each row: not more than bytes.
    std::size_t extras() {
        const auto number = next<long long>();
        if (number < 0 || std::cmp_greater(number, text_.size()))
            malformed(fmt::format("it announces {} more numbers in each row", number));
        return static_cast<std::size_t>(number);
    }

    /// Row i of a table of cells: its number, and its corners.
    void corners(const char* cell, Simplices& cells, Index i, Eigen::Index points) {
        expect(i, "the number of a ", cell);
        for (Index& corner : cells.row(i)) {
            corner = next<Index>();
            if (corner < 0 || corner >= points)
                malformed(fmt::format("{} {} has the corner {}", cell, i, corner));
        }
    }

    void expect(Index value, const char* what, const char* cell = "") {
        const auto found = next<long long>();
        if (found != value)
            malformed(fmt::format("{}{} is {}, not {}", what, cell, found, value));
    }

    /// Nothing may follow but a comment, and the last line must be whole.
    void expect_end() {
        const auto line = std::min(text_.find('\n', at_), text_.size());
        const auto rest = text_.find_first_not_of(" \t\r\n", at_);
        const bool is_comment = rest == std::string::npos || text_[rest] == '#';
        if (line == text_.size() || !is_comment || text_.back() != '\n')
            malformed(fmt::format("its last row ends after {} bytes, but the file does not", at_));
    }

    [[noreturn]] void malformed(const std::string& what) const {
        throw SolverFailure(
            fmt::format("tetgen wrote an invalid file {}: {}\n"
                        "Check that the program tetgen on PATH is the mesher TetGen.",
                        name_, what));
    }

private:
    std::string read_regular_file(const std::filesystem::path& path) const {
        try {
            const RegularFile file(path, RegularFile::Links::refused);
            if (!file.is_regular())
                malformed("it is not a regular file");
            auto text = file.read();
            if (text.size() < file.size())
                malformed("it cannot be read to the end");
            return text;
        } catch (const IoError& error) {
            malformed(fmt::format("it cannot be read: {}", error.what()));
        }
    }

    std::string name_;
    std::string text_;
    std::size_t at_ = 0;
};

} // namespace

std::string smesh_text(const TetgenInput& input) {
    fmt::memory_buffer text;
    const auto end = std::back_inserter(text);
    fmt::format_to(end, "{} 3 0 0\n", input.points.rows());
    append_places(text, input.points);
    // one number for triangles in one plane: TetGen drops the edges between those that have the
    // same
    fmt::format_to(end, "{} 1\n", input.triangles.rows());
    for (Eigen::Index f = 0; f < input.triangles.rows(); ++f)
        fmt::format_to(end, "3 {} {} {} {}\n", input.triangles(f, 0), input.triangles(f, 1),
                       input.triangles(f, 2), input.patches[f] + 1);
    fmt::format_to(end, "{}\n", input.holes.rows());
    append_places(text, input.holes);
    return fmt::to_string(text);
}

Points read_tetgen_points(const std::filesystem::path& path) {
    Numbers numbers(path);
    const Index rows = numbers.count(4);
    numbers.expect(3, "the dimension");
    const auto attributes = numbers.extras();
    const auto extras = attributes + numbers.extras(); // and the boundary marker
    Points points(rows, 3);
    for (Index i = 0; i < rows; ++i) {
        numbers.expect(i, "the number of a point");
        for (int j = 0; j < 3; ++j)
            points(i, j) = numbers.next<double>();
        if (!points.row(i).allFinite())
            numbers.malformed(fmt::format("point {} is not finite", i));
        for (std::size_t j = 0; j < extras; ++j)
            numbers.next<double>();
    }
    numbers.expect_end();
    return points;
}

Simplices read_tetgen_cells(const std::filesystem::path& path, Eigen::Index points) {
    Numbers numbers(path);
    const Index rows = numbers.count(5);
    numbers.expect(4, "the number of corners");
    const auto extras = numbers.extras();
    Simplices cells(rows, 4);
    for (Index i = 0; i < rows; ++i) {
        numbers.corners("tetrahedron", cells, i, points);
        for (std::size_t j = 0; j < extras; ++j)
            numbers.next<double>();
    }
    numbers.expect_end();
    return cells;
}

std::pair<Simplices, std::vector<Index>> read_tetgen_faces(const std::filesystem::path& path,
                                                           Eigen::Index points, Index facets) {
    Numbers numbers(path);
    const Index rows = numbers.count(5);
    numbers.expect(1, "the count of markers");
    Simplices faces(rows, 3);
    std::vector<Index> markers(rows);
    for (Index i = 0; i < rows; ++i) {
        numbers.corners("face", faces, i, points);
        const Index marker = numbers.next<Index>();
        if (marker < 1 || marker > facets)
            numbers.malformed(fmt::format("face {} is on facet {}", i, marker));
        markers[i] = marker - 1;
    }
    numbers.expect_end();
    return {std::move(faces), std::move(markers)};
}

std::vector<std::pair<Index, Index>> crossing_facets(const std::string& output, Index facets) {
    std::vector<std::pair<Index, Index>> pairs;
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);) {
        int a = 0, b = 0;
        const bool found =
            std::sscanf(line.c_str(), " Facet #%d intersects facet #%d", &a, &b) == 2 ||
            std::sscanf(line.c_str(), " Facet #%d duplicates facet #%d", &a, &b) == 2;
        if (found && a >= 1 && b >= 1 && a <= facets && b <= facets && a != b)
            pairs.emplace_back(std::min(a, b) - 1, std::max(a, b) - 1);
    }
    sort_unique(pairs);
    return pairs;
}

} // namespace polydec
