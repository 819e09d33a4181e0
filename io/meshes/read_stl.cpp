// SPDX-License-Identifier: MIT
#include "io/byte_order.h"
#include "io/meshes/readers.h"
#include "io/scanner.h"
#include "meshes/weld.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace polydec {

namespace {

constexpr std::size_t header_bytes = 84;   // free text of 80, the number of triangles
constexpr std::size_t triangle_bytes = 50; // a normal, three vertices, two bytes of anything

/// Corners of triangles, three after the other, become vertices: a file has no others. Numbers
/// ascend by first appearance.
Mesh joined(Points places) {
    Mesh corners{std::move(places), {}, {}};
    const auto count = static_cast<Index>(corners.points.rows());
    corners.simplices.resize(count / 3, 3);
    std::iota(corners.simplices.data(), corners.simplices.data() + count, 0);
    if (count == 0)
        return corners;
    const double length = weld_length(corners.points);
    Joined welded = weld(std::move(corners), length);
    Mesh& mesh = welded.mesh;
    mesh.warnings.clear();
    if (welded.apart > 0)
        mesh.warnings.push_back(fmt::format("joined {} {} of STL triangles with others at most "
                                            "{:.3g} away (1e-9 of the mesh's size)",
                                            welded.apart, welded.apart == 1 ? "corner" : "corners",
                                            length));
    return std::move(mesh);
}

std::size_t promised_bytes(const SourceFile& file) {
    const std::size_t triangles =
        number_at<std::uint32_t>(file.text.data() + header_bytes - 4, std::endian::little);
    return header_bytes + triangle_bytes * triangles;
}

void read_corner(const SourceFile& file, std::size_t triangle, std::size_t corner, Points& places) {
    constexpr std::size_t normal_bytes = 12;
    const char* place =
        file.text.data() + header_bytes + triangle_bytes * triangle + normal_bytes * (1 + corner);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double value = number_at<float>(place + 4 * axis, std::endian::little);
        if (!std::isfinite(value))
            refuse_contents(
                file.name,
                fmt::format(
                    "corner {} of triangle {} (counted from 0) has a coordinate that is NaN or "
                    "infinite; expected finite numbers; repair or remove the triangle",
                    corner, triangle),
                {.degree = 2, .cells = {static_cast<Index>(triangle)}});
        places(3 * triangle + corner, axis) = value + 0.0; // no zero has a sign
    }
}

/// Of the triangles that the header promises; what follows them is left out.
Mesh read_binary(const SourceFile& file) {
    const std::size_t triangles = (promised_bytes(file) - header_bytes) / triangle_bytes;
    Points places(checked_count(3 * triangles, "corners of triangles", file), 3);
    for (std::size_t triangle = 0; triangle < triangles; ++triangle)
        for (std::size_t corner = 0; corner < 3; ++corner)
            read_corner(file, triangle, corner, places);
    Mesh mesh = joined(std::move(places));
    if (file.text.size() > promised_bytes(file))
        mesh.warnings.push_back(fmt::format("left out {} bytes after the {} triangles",
                                            file.text.size() - promised_bytes(file), triangles));
    return mesh;
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
        return joined(points_from(coordinates_));
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
        return lower_case(ahead.word(expected)) == keyword;
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
        const Index number = checked_count(coordinates_.size() / 3, "corners of triangles", file_);
        for (int axis = 0; axis < 3; ++axis)
            coordinates_.push_back(scanner_.coordinate(number) + 0.0);
    }

    void expect(std::string_view keyword) {
        const auto word = scanner_.word(keyword);
        if (lower_case(word) != keyword)
            scanner_.fail(
                fmt::format("found {}; expected {}; correct the line or export the file again",
                            quote_word(word), keyword));
    }

    const SourceFile& file_;
    Scanner scanner_;
    std::vector<double> coordinates_;
};

/// The number of triangles in a binary header has a zero byte, unless they are very many.
bool begins_like_text(const SourceFile& file) {
    if (file.text.find('\0') < header_bytes)
        return false;
    Scanner scanner(file.name, file.text);
    return !scanner.at_end() && lower_case(scanner.word("solid")) == "solid";
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
    if (has_header)
        refuse_contents(
            file.name,
            fmt::format("the file has {} bytes; expected {} for the {} triangles that its header "
                        "announces, or a text that begins with solid; export it again{}",
                        file.text.size(), promised_bytes(file),
                        (promised_bytes(file) - header_bytes) / triangle_bytes,
                        promised_bytes(file) > file.text.size() ? ", it seems cut off" : ""));
    refuse_contents(file.name,
                    fmt::format("the file has {} bytes; expected a binary STL of at least {}, or a "
                                "text that begins with solid; export it again",
                                file.text.size(), header_bytes));
}

} // namespace polydec
