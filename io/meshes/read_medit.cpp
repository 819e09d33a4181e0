// SPDX-License-Identifier: MIT
#include "base/read_number.h"
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

/// A word that begins with a letter and is no number, as nan is.
bool is_keyword(std::string_view word) {
    const char c = word[0], *const end = word.data() + word.size();
    double number = 0;
    return ((c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z')) &&
           read_number(word.data(), end, number).ptr != end;
}

/// Behind the last record of a section.
void end_section(Scanner scanner, std::size_t count, const char* keyword) {
    if (!scanner.at_end() && !is_keyword(Scanner(scanner).word("a keyword")))
        scanner.fail(fmt::format("more follows after {} {}; expected a keyword or the end of the "
                                 "file; correct the number of {}",
                                 count, keyword, keyword));
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
            if (is_keyword(word) && !places_.emplace(word, scanner).second)
                keyword_place.fail(
                    fmt::format("the section {} occurs twice; expected it once; join the two",
                                quote_word(word)));
        }
    }

    bool has(std::string_view keyword) const { return places_.count(keyword) > 0; }

    Scanner at(std::string_view keyword) const {
        const auto found = places_.find(keyword);
        if (found == places_.end())
            begin_.fail(fmt::format("the file has no section {}; expected MEDIT's text format with "
                                    "Dimension, Vertices and cells; check the format",
                                    keyword));
        return found->second;
    }

private:
    Scanner begin_;
    std::map<std::string, Scanner, std::less<>> places_;
};

int read_dimension(const Sections& sections) {
    Scanner scanner = sections.at("Dimension");
    const auto dimension = scanner.integer("the dimension");
    if (dimension != 2 && dimension != 3)
        scanner.fail(
            fmt::format("Dimension {}; expected 2 or 3; write the mesh as .nsc", dimension));
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
    end_section(scanner, static_cast<std::size_t>(count), "Vertices");
    return points;
}

/// A section of cells: the corners come first of the nodes of each.
struct CellSection {
    const char* keyword;
    int dimension;
    std::size_t corners, nodes;
};

constexpr std::array cell_sections{
    CellSection{"Edges", 1, 2, 2},          CellSection{"EdgesP2", 1, 2, 3},
    CellSection{"Triangles", 2, 3, 3},      CellSection{"TrianglesP2", 2, 3, 6},
    CellSection{"Quadrilaterals", 2, 4, 4}, CellSection{"QuadrilateralsQ2", 2, 4, 9},
    CellSection{"Tetrahedra", 3, 4, 4},     CellSection{"TetrahedraP2", 3, 4, 10},
    CellSection{"Hexahedra", 3, 8, 8},      CellSection{"Hexaedra", 3, 8, 8},
    CellSection{"HexahedraQ2", 3, 8, 27},   CellSection{"Prisms", 3, 6, 6},
    CellSection{"Wedges", 3, 6, 6},         CellSection{"Pentahedra", 3, 6, 6},
    CellSection{"PrismsP2", 3, 6, 18},      CellSection{"Pyramids", 3, 5, 5},
    CellSection{"PyramidsP2", 3, 5, 14},
};

/// Adds the cells of a section, their references as tags if all are whole numbers.
void read_section(const Sections& sections, const CellSection& section, Index vertices,
                  CellLists& cells) {
    Scanner scanner = sections.at(section.keyword);
    const auto count =
        static_cast<std::size_t>(scanner.count(section.keyword, 2 * (section.nodes + 1)));
    std::vector<Index> numbers(count * section.corners);
    std::vector<double> references(count);
    for (std::size_t cell = 0; cell < count; ++cell) {
        for (std::size_t node = 0; node < section.nodes; ++node) {
            const Index vertex = scanner.vertex(vertices, 1);
            if (node < section.corners)
                numbers[cell * section.corners + node] = vertex;
        }
        references[cell] = scanner.number("a reference");
    }
    end_section(scanner, count, section.keyword);
    const auto tags = cells.tags_from(references, count);
    for (std::size_t cell = 0; cell < count; ++cell) {
        cells.add(section.dimension,
                  std::span(numbers).subspan(cell * section.corners, section.corners), tags[cell]);
        cells.leave_out_nodes(section.nodes - section.corners);
    }
}

} // namespace

Mesh read_medit(const SourceFile& file) {
    const Sections sections({file.name, file.text, {.comment = '#'}});
    Points points = read_vertices(sections, read_dimension(sections));
    const auto vertices = static_cast<Index>(points.rows());
    CellLists cells;
    for (const auto& section : cell_sections)
        if (sections.has(section.keyword))
            read_section(sections, section, vertices, cells);
    return std::move(cells).mesh(std::move(points), file);
}

} // namespace polydec
