// SPDX-License-Identifier: MIT
#include "io/meshes/readers.h"
#include "io/scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace polydec {

namespace {

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// The keyword without the prefixes for texture, colors and normals, which stand behind the
/// coordinates of a vertex.
std::string_view without_prefixes(std::string_view keyword) {
    for (;;)
        if (keyword.substr(0, 2) == "ST")
            keyword.remove_prefix(2);
        else if (keyword.substr(0, 1) == "C" || keyword.substr(0, 1) == "N")
            keyword.remove_prefix(1);
        else
            return keyword;
}

/// The text behind the keyword, and the coordinates that it tells of each vertex; 0 for plain OFF.
struct Beginning {
    Scanner scanner;
    Eigen::Index axes = 0;
};

/// "nOFF" tells the dimension in front of the counts; a 4 stands for one coordinate more.
Beginning behind_n(Scanner scanner, bool has_four) {
    constexpr std::int64_t most = 1000;
    const auto axes = scanner.integer("the dimension of the points");
    if (axes < 1 || axes > most)
        scanner.fail(fmt::format("points of dimension {}; expected 1 to {} after nOFF; correct it",
                                 axes, most));
    return {scanner, axes + (has_four ? 1 : 0)};
}

/// Goes behind the keyword, which is optional. Some programs write "OFF8 6 12", without a blank.
Beginning behind_keyword(const Scanner& start) {
    Scanner scanner = start;
    const auto word = scanner.word("the keyword OFF");
    if (is_digit(word[0]) || word[0] == '-' || word[0] == '+') {
        const auto digits = std::find_if_not(word.begin() + 1, word.end(), is_digit);
        if (digits == word.end())
            return {start};
    }

    const auto keyword = without_prefixes(word);
    Scanner next = scanner;
    if (keyword.ends_with("OFF") && !next.at_line_end() && next.word("") == "BINARY")
        scanner.fail("the file is a binary OFF; expected text; convert it to text or PLY");
    if (keyword == "nOFF" || keyword == "4nOFF")
        return behind_n(scanner, keyword[0] == '4');
    if (keyword == "4OFF")
        return {scanner, 4};
    if (keyword == "OFF" || keyword == "off")
        return {scanner};
    if (keyword.substr(0, 3) == "OFF" && is_digit(keyword[3])) {
        Scanner glued = start;
        glued.at_end();
        glued.skip(word.size() - keyword.size() + 3);
        return {glued};
    }
    scanner.fail(fmt::format("the file begins with {}; expected the keyword OFF; check the format",
                             quote_word(word)));
}

/// Points of the plane have two words in each of the first two lines; all others have three.
Eigen::Index count_axes(Scanner scanner, Index vertices) {
    for (Index vertex = 0; vertex < std::min(vertices, Index{2}); ++vertex) {
        scanner.word("a coordinate");
        if (scanner.at_line_end())
            return 3;
        scanner.word("a coordinate");
        if (!scanner.at_line_end())
            return 3;
        scanner.next_line();
    }
    return 2;
}

/// Colors, normals and texture behind the coordinates are left out with the rest of the line;
/// `alone` are coordinates that the lines themselves have told to be all.
Points read_vertices(Scanner& scanner, Index count, Eigen::Index axes, bool alone) {
    Points points(count, axes);
    for (Index vertex = 0; vertex < count; ++vertex) {
        for (Eigen::Index axis = 0; axis < axes; ++axis)
            points(vertex, axis) = scanner.coordinate(vertex);
        if (alone)
            scanner.end_line("a vertex of two coordinates, as of the first");
        else
            scanner.next_line();
    }
    return points;
}

void read_faces(Scanner& scanner, Index count, PolygonMesh& polygons, const SourceFile& file) {
    const auto vertices = static_cast<Index>(polygons.points.rows());
    reserve_faces(polygons, count, scanner.remaining());
    for (Index face = 0; face < count; ++face) {
        if (scanner.at_end())
            scanner.fail(fmt::format("the file ends after {} of {} faces; expected the others; "
                                     "export it again, it seems cut off",
                                     face, count));
        const Index corners = scanner.count("corners of a face", 2);
        for (Index corner = 0; corner < corners; ++corner)
            polygons.corners.push_back(scanner.vertex(vertices, 0));
        close_face(polygons, file);
        scanner.next_line();
    }
}

} // namespace

Mesh read_off(const SourceFile& file) {
    auto [scanner, axes] = behind_keyword({file.name, file.text, {.comment = '#'}});
    const Index vertices =
        scanner.count("vertices", 2 * static_cast<std::size_t>(axes == 0 ? 2 : axes));
    const Index faces = scanner.count("faces", 2);
    scanner.integer("the number of edges");

    PolygonMesh polygons;
    const bool is_told = axes != 0;
    if (!is_told)
        axes = count_axes(scanner, vertices);
    polygons.points = read_vertices(scanner, vertices, axes, !is_told && axes == 2);
    read_faces(scanner, faces, polygons, file);

    const bool is_curve = polygons.all_have(2);
    Mesh mesh = is_curve ? segments_of(polygons) : split_polygons(std::move(polygons));
    if (!scanner.at_end())
        mesh.warnings.push_back(fmt::format("left out everything after the {} faces, from line {}",
                                            faces, scanner.line()));
    return mesh;
}

} // namespace polydec
