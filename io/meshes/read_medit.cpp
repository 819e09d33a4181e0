// SPDX-License-Identifier: MIT
#include "io/meshes/cell_lists.h"
#include "io/meshes/readers.h"
#include "io/scanner.h"

#include <fmt/format.h>

#include <array>
#include <map>
#include <string>
#include <utility>

namespace polydec {

namespace {

bool is_letter(char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

/// Where each section begins, by its keyword. The sections may come in any order.
class Sections {
public:
    explicit Sections(Scanner scanner) : begin_(scanner) {
        while (!scanner.at_end()) {
            const Scanner keyword_place = scanner;
            const auto word = scanner.word("a keyword");
            if (word == "End")
                break;
            if (is_letter(word[0]) && !places_.emplace(word, scanner).second) {
                keyword_place.fail(fmt::format("the section {} is there a second time; expected "
                                               "one; join the two",
                                               quote_word(word)));
            }
        }
    }

    bool has(std::string_view keyword) const { return places_.count(keyword) > 0; }

    Scanner at(std::string_view keyword) const {
        const auto found = places_.find(keyword);
        if (found == places_.end()) {
            begin_.fail(fmt::format("the file has no section {}; expected MEDIT's text format with "
                                    "Dimension, Vertices and cells; check the format",
                                    keyword));
        }
        return found->second;
    }

private:
    Scanner begin_;
    std::map<std::string, Scanner, std::less<>> places_;
};

int read_dimension(const Sections& sections) {
    Scanner scanner = sections.at("Dimension");
    const auto dimension = scanner.integer("the dimension");
    if (dimension != 2 && dimension != 3) {
        scanner.fail(
            fmt::format("Dimension {}; expected 2 or 3; write the mesh as .nsc", dimension));
    }
    return static_cast<int>(dimension);
}

/// Behind the coordinates and behind the corners stands a reference, the number of a part.
Points read_vertices(const Sections& sections, int dimension) {
    Scanner scanner = sections.at("Vertices");
    const Index count = scanner.count("vertices", 2 * (static_cast<std::size_t>(dimension) + 1));
    Points points(count, dimension);
    for (Index vertex = 0; vertex < count; ++vertex) {
        for (int axis = 0; axis < dimension; ++axis)
            points(vertex, axis) = scanner.coordinate(vertex);
        scanner.number("a reference");
    }
    return points;
}

/// Reads the cells of a section, and their references as tags; none where it is missing.
void read_cells(const Sections& sections, const char* keyword, int corners, Mesh& mesh) {
    const auto vertices = static_cast<Index>(mesh.points.rows());
    mesh.simplices.resize(0, corners);
    if (!sections.has(keyword))
        return;
    Scanner scanner = sections.at(keyword);
    const Index count = scanner.count(keyword, 2 * (static_cast<std::size_t>(corners) + 1));
    mesh.simplices.resize(count, corners);
    mesh.tags.resize(static_cast<std::size_t>(count));
    bool are_tags = true;
    for (Index cell = 0; cell < count; ++cell) {
        for (int corner = 0; corner < corners; ++corner)
            mesh.simplices(cell, corner) = scanner.vertex(vertices, 1);
        const auto tag = tag_from(scanner.number("a reference"));
        mesh.tags[static_cast<std::size_t>(cell)] = tag.value_or(0);
        are_tags = are_tags && tag.has_value();
    }
    mesh.tags = are_tags ? tags_or_none(std::move(mesh.tags)) : std::vector<Index>();
}

/// Leaving such cells out would silently make a hole in the mesh.
void refuse_others(const Sections& sections, std::string_view keyword) {
    if (sections.has(keyword) && sections.at(keyword).count(keyword, 1) > 0) {
        sections.at(keyword).fail(fmt::format("the mesh has {}; expected tetrahedra, triangles or "
                                              "edges; split them before",
                                              keyword));
    }
}

} // namespace

Mesh read_medit(const SourceFile& file) {
    const Sections sections({file.name, file.text, {.comment = '#'}});
    for (const char* solid : {"Hexahedra", "Hexaedra", "Prisms", "Pyramids"})
        refuse_others(sections, solid);

    Mesh mesh;
    mesh.points = read_vertices(sections, read_dimension(sections));
    constexpr std::array<const char*, 3> kinds{"Tetrahedra", "Triangles", "Edges"};
    for (int kind = 0; kind < 3; ++kind) {
        if (kind == 1)
            refuse_others(sections, "Quadrilaterals");
        read_cells(sections, kinds[static_cast<std::size_t>(kind)], 4 - kind, mesh);
        if (mesh.simplices.rows() > 0)
            return mesh;
    }
    return mesh;
}

} // namespace polydec
