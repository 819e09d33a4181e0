// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "io/byte_reader.h"
#include "io/meshes/readers.h"
#include "io/scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace polydec {

namespace {

constexpr std::size_t header_bytes = 84;   // free text of 80, the number of triangles
constexpr std::size_t triangle_bytes = 50; // a normal, three vertices, two bytes of anything

struct Corner {
    std::array<double, 3> place;
    Index number;
};

/// Corners at equal places become one vertex, numbered by first appearance. Sorted rather than
/// hashed: -0 was made 0 before, so that the order of doubles tells equal from different.
Mesh join(std::vector<Corner> corners) {
    std::sort(corners.begin(), corners.end(), [](const Corner& a, const Corner& b) {
        return a.place != b.place ? a.place < b.place : a.number < b.number;
    });

    std::vector<Index> first_at_place(corners.size());
    Index first = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const bool same = i > 0 && corners[i].place == corners[i - 1].place;
        first = same ? first : corners[i].number;
        first_at_place[static_cast<std::size_t>(corners[i].number)] = first;
    }

    Mesh mesh;
    mesh.simplices.resize(static_cast<Eigen::Index>(corners.size() / 3), 3);
    std::vector<Index> vertex_of(corners.size());
    Index vertices = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto earlier = static_cast<std::size_t>(first_at_place[i]);
        vertex_of[i] = earlier == i ? vertices++ : vertex_of[earlier];
        mesh.simplices(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3)) =
            vertex_of[i];
    }

    mesh.points.resize(vertices, 3);
    for (const auto& [place, number] : corners) {
        mesh.points.row(vertex_of[static_cast<std::size_t>(number)]) =
            Eigen::RowVector3d(place[0], place[1], place[2]);
    }
    return mesh;
}

std::size_t promised_bytes(const SourceFile& file) {
    const std::size_t triangles =
        number_at<std::uint32_t>(file.text.data() + header_bytes - 4, std::endian::little);
    return header_bytes + triangle_bytes * triangles;
}

Corner binary_corner(const SourceFile& file, std::size_t triangle, std::size_t corner) {
    constexpr std::size_t normal_bytes = 12;
    const char* place =
        file.text.data() + header_bytes + triangle_bytes * triangle + normal_bytes * (1 + corner);
    Corner read{};
    read.number = static_cast<Index>(3 * triangle + corner);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double value = number_at<float>(place + 4 * axis, std::endian::little);
        if (!std::isfinite(value)) {
            throw InvalidInput(
                fmt::format(
                    "{}: corner {} of triangle {} (counted from 0) has a coordinate that is NaN or "
                    "infinite; expected finite numbers; repair or remove the triangle",
                    file.name, corner, triangle),
                {.degree = 2, .cells = {static_cast<Index>(triangle)}, .path = file.name});
        }
        read.place[axis] = value + 0.0;
    }
    return read;
}

/// Of the triangles that the header promises; what follows them is left out.
Mesh read_binary(const SourceFile& file) {
    const std::size_t triangles = (promised_bytes(file) - header_bytes) / triangle_bytes;
    checked_count(3 * triangles, "corners of triangles", file);
    std::vector<Corner> corners;
    corners.reserve(3 * triangles);
    for (std::size_t triangle = 0; triangle < triangles; ++triangle)
        for (std::size_t corner = 0; corner < 3; ++corner)
            corners.push_back(binary_corner(file, triangle, corner));
    Mesh mesh = join(std::move(corners));
    if (file.text.size() > promised_bytes(file)) {
        mesh.warnings.push_back(fmt::format("{} bytes behind the {} triangles left out",
                                            file.text.size() - promised_bytes(file), triangles));
    }
    return mesh;
}

bool equal_ignoring_case(std::string_view word, std::string_view small) {
    return std::equal(word.begin(), word.end(), small.begin(), small.end(), [](char a, char b) {
        return (a >= 'A' && a <= 'Z' ? static_cast<char>(a + 32) : a) == b;
    });
}

/// The words of a text file, in which any letter may be a capital.
class TextReader {
public:
    explicit TextReader(const SourceFile& file) : file_(file), scanner_(file.name, file.text) {}

    /// One file may hold several solids, one after the other.
    Mesh read() {
        while (!scanner_.at_end()) {
            expect("solid");
            scanner_.next_line();
            while (!ends_solid())
                read_facet();
            scanner_.next_line();
        }
        return join(std::move(corners_));
    }

private:
    bool ends_solid() {
        const bool ends = comes("endsolid", "facet or endsolid");
        if (ends)
            expect("endsolid");
        return ends;
    }

    bool comes(std::string_view keyword, std::string_view expected) const {
        Scanner ahead = scanner_;
        return equal_ignoring_case(ahead.word(expected), keyword);
    }

    /// The normal follows from the vertices; in many files it is wrong, NaN or left out.
    void read_facet() {
        expect("facet");
        constexpr int most_words = 4; // normal x y z
        for (int word = 0; word < most_words && !comes("outer", "outer"); ++word)
            scanner_.word("a normal");
        expect("outer");
        expect("loop");
        for (int corner = 0; corner < 3; ++corner) {
            expect("vertex");
            read_vertex();
        }
        expect("endloop");
        expect("endfacet");
    }

    void read_vertex() {
        Corner corner{};
        corner.number = checked_count(corners_.size(), "corners of triangles", file_);
        for (double& value : corner.place)
            value = scanner_.coordinate(corner.number) + 0.0;
        corners_.push_back(corner);
    }

    void expect(std::string_view keyword) {
        const auto word = scanner_.word(keyword);
        if (!equal_ignoring_case(word, keyword)) {
            scanner_.fail(fmt::format("{} stands here; expected {}; correct the line or export the "
                                      "file again",
                                      quote_word(word), keyword));
        }
    }

    const SourceFile& file_;
    Scanner scanner_;
    std::vector<Corner> corners_;
};

/// The number of triangles in a binary header has a zero byte, unless they are very many.
bool begins_like_text(const SourceFile& file) {
    if (file.text.find('\0') < header_bytes)
        return false;
    Scanner scanner(file.name, file.text);
    return !scanner.at_end() && equal_ignoring_case(scanner.word("solid"), "solid");
}

} // namespace

/// A binary file may begin with "solid" too: its size decides.
Mesh read_stl(const SourceFile& file) {
    const bool has_header = file.text.size() >= header_bytes;
    if (has_header && promised_bytes(file) == file.text.size())
        return read_binary(file);
    if (begins_like_text(file))
        return TextReader(file).read();
    if (has_header && promised_bytes(file) > header_bytes &&
        promised_bytes(file) < file.text.size())
        return read_binary(file);
    if (has_header) {
        throw InvalidInput(
            fmt::format(
                "{}: the file has {} bytes; expected {} for the {} triangles that its header "
                "promises, or a text that begins with solid; export it again{}",
                file.name, file.text.size(), promised_bytes(file),
                (promised_bytes(file) - header_bytes) / triangle_bytes,
                promised_bytes(file) > file.text.size() ? ", it seems cut off" : ""),
            {.path = file.name});
    }
    throw InvalidInput(fmt::format("{}: the file has {} bytes; expected a binary STL of at least "
                                   "{}, or a text that begins with solid; export it again",
                                   file.name, file.text.size(), header_bytes),
                       {.path = file.name});
}

} // namespace polydec
