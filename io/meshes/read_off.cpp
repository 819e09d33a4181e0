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

/// Goes behind the keyword, which is optional. Some programs write "OFF8 6 12", without a blank.
Scanner behind_keyword(const Scanner& start) {
    Scanner scanner = start;
    const auto word = scanner.word("the keyword OFF");
    if (is_digit(word[0]) || word[0] == '-' || word[0] == '+') {
        const auto digits = std::find_if_not(word.begin() + 1, word.end(), is_digit);
        if (digits == word.end())
            return start;
    }

    const auto keyword = without_prefixes(word);
    if (keyword == "4OFF" || keyword.substr(0, 4) == "nOFF" || keyword == "4nOFF") {
        scanner.fail(fmt::format("{} has vertices of another dimension than 3; expected OFF with "
                                 "x y z; write the mesh as .nsc",
                                 quote_word(word)));
    }
    if (keyword == "OFF" || keyword == "off") {
        Scanner next = scanner;
        if (!next.at_line_end() && next.word("") == "BINARY")
            scanner.fail("the file is a binary OFF; expected text; convert it to text or PLY");
        return scanner;
    }
    if (keyword.substr(0, 3) == "OFF" && is_digit(keyword[3])) {
        Scanner glued = start;
        glued.at_end();
        glued.skip(word.size() - keyword.size() + 3);
        return glued;
    }
    scanner.fail(fmt::format("the file begins with {}; expected the keyword OFF; check the format",
                             quote_word(word)));
}

/// Colors, normals and texture behind the coordinates are left out with the rest of the line.
Points read_vertices(Scanner& scanner, Index count) {
    Points points(count, 3);
    for (Index vertex = 0; vertex < count; ++vertex) {
        for (int axis = 0; axis < 3; ++axis)
            points(vertex, axis) = scanner.coordinate(vertex);
        scanner.next_line();
    }
    return points;
}

void read_faces(Scanner& scanner, Index count, PolygonMesh& polygons, const SourceFile& file) {
    const auto vertices = static_cast<Index>(polygons.points.rows());
    reserve_faces(polygons, count, scanner.remaining());
    for (Index face = 0; face < count; ++face) {
        if (scanner.at_end()) {
            scanner.fail(fmt::format("the file ends after {} of {} faces; expected the others; "
                                     "export it again, it seems cut off",
                                     face, count));
        }
        const Index corners = scanner.count("corners of a face", 2);
        for (Index corner = 0; corner < corners; ++corner)
            polygons.corners.push_back(scanner.vertex(vertices, 0));
        close_face(polygons, file);
        scanner.next_line();
    }
}

} // namespace

Mesh read_off(const SourceFile& file) {
    Scanner scanner = behind_keyword({file.name, file.text, {.comment = '#'}});
    const Index vertices = scanner.count("vertices", 6);
    const Index faces = scanner.count("faces", 2);
    scanner.integer("the number of edges");

    PolygonMesh polygons;
    polygons.points = read_vertices(scanner, vertices);
    read_faces(scanner, faces, polygons, file);

    Mesh mesh = split_polygons(std::move(polygons));
    if (!scanner.at_end()) {
        mesh.warnings.push_back(fmt::format("what follows the {} faces was left out, from line {}",
                                            faces, scanner.line()));
    }
    return mesh;
}

} // namespace polydec
