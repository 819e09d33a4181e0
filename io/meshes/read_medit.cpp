// SPDX-License-Identifier: MIT
#include "io/meshes/cell_lists.h"
#include "io/meshes/readers.h"
#include "io/scanner.h"

#include <fmt/format.h>

#include <array>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

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

/// Adds the cells of a section, their references as tags if all are whole numbers. Their number.
std::size_t read_cells(const Sections& sections, int dimension, Index vertices,
                       const SourceFile& file, CellLists& cells) {
    constexpr std::array<const char*, 3> keywords{"Edges", "Triangles", "Tetrahedra"};
    const char* const keyword = keywords[static_cast<std::size_t>(dimension) - 1];
    if (!sections.has(keyword))
        return 0;
    const auto corners = static_cast<std::size_t>(dimension) + 1;
    Scanner scanner = sections.at(keyword);
    const auto count = static_cast<std::size_t>(scanner.count(keyword, 2 * (corners + 1)));
    std::vector<Index> numbers(count * corners), tags(count);
    bool are_tags = true;
    for (std::size_t cell = 0; cell < count; ++cell) {
        for (std::size_t corner = 0; corner < corners; ++corner)
            numbers[cell * corners + corner] = scanner.vertex(vertices, 1);
        const auto tag = tag_from(scanner.number("a reference"));
        tags[cell] = tag.value_or(0);
        are_tags = are_tags && tag.has_value();
    }
    for (std::size_t cell = 0; cell < count; ++cell)
        cells.add(dimension, std::span(numbers).subspan(cell * corners, corners),
                  are_tags ? tags[cell] : 0, file);
    return count;
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

    Points points = read_vertices(sections, read_dimension(sections));
    const auto vertices = static_cast<Index>(points.rows());
    CellLists cells;
    int dimension = 3;
    while (read_cells(sections, dimension, vertices, file, cells) == 0 && dimension > 1)
        if (--dimension == 2)
            refuse_others(sections, "Quadrilaterals");
    if (dimension > 1)
        read_cells(sections, dimension - 1, vertices, file, cells);
    return std::move(cells).mesh(std::move(points));
}

} // namespace polydec
