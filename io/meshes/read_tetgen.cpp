// SPDX-License-Identifier: MIT
#include "io/meshes/cell_lists.h"
#include "io/meshes/readers.h"
#include "io/scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <span>
#include <system_error>
#include <utility>
#include <vector>

namespace polydec {

namespace {

constexpr Scanner::Syntax syntax{.comment = '#'};

/// The vertices, and the number of the first one in the file: 0 or 1.
struct Nodes {
    Points points;
    Index first = 0;

    Index size() const { return static_cast<Index>(points.rows()); }
};

/// Records are numbered one after the other; `first` is the number of the first.
void read_number(Scanner& scanner, const char* record, Index place, std::int64_t first) {
    const auto number = scanner.integer(fmt::format("the number of a {}", record));
    if (number != first + place)
        scanner.fail(fmt::format(
            "a {} has the number {}; expected {}, since numbers must be consecutive; renumber them",
            record, number, first + place));
}

/// Records may be numbered from 0 or from 1; which, the first one tells.
Index first_number(Scanner scanner, const char* record) {
    const auto first =
        scanner.at_end() ? 0 : scanner.integer(fmt::format("the number of a {}", record));
    if (first != 0 && first != 1)
        scanner.fail(fmt::format("the first {} has the number {}; expected 0 or 1; number them "
                                 "from there",
                                 record, first));
    return static_cast<Index>(first);
}

/// Behind the coordinates stand attributes and a boundary marker, which are passed over.
Nodes read_nodes(const SourceFile& file) {
    Scanner scanner(file.name, file.text, syntax);
    const Index count = scanner.count("vertices", 0);
    const auto dimension = scanner.at_line_end() ? 3 : scanner.integer("the dimension");
    if (dimension != 2 && dimension != 3)
        scanner.fail(fmt::format("points of dimension {}; expected 2 or 3; write the mesh as .nsc",
                                 dimension));
    const auto least_bytes = 2 * (static_cast<std::size_t>(dimension) + 1);
    scanner.as_count(count, "vertices", least_bytes);
    scanner.next_line();

    Nodes nodes{Points(count, dimension), first_number(scanner, "vertex")};
    for (Index vertex = 0; vertex < count; ++vertex) {
        read_number(scanner, "vertex", vertex, nodes.first);
        for (Eigen::Index axis = 0; axis < dimension; ++axis) {
            scanner.stay_on_line("a vertex");
            nodes.points(vertex, axis) = scanner.coordinate(vertex);
        }
        scanner.next_line();
    }
    end_records(scanner, count, "vertices");
    return nodes;
}

/// The words behind the corners of a cell.
struct Extras {
    int nodes = 0;      ///< of the option -o2, on the edges
    int attributes = 0; ///< the last of them is the number of the region
    int neighbors = 0;
};

/// Reads the attributes of a cell, as many as there are; gives the last one.
double read_attributes(Scanner& scanner, int attributes) {
    double value = 0.0;
    for (int i = 0; i < attributes && !scanner.at_line_end(); ++i)
        value = scanner.number("an attribute");
    return value;
}

/// Adds the cells, one a line: number, corners, extras.
void add_cells(CellLists& cells, const Nodes& nodes, Scanner& scanner, Index count, int corners,
               const Extras& extras) {
    std::vector<Index> numbers;
    std::vector<double> groups;
    const auto first = first_number(scanner, "cell");
    for (Index cell = 0; cell < count; ++cell) {
        read_number(scanner, "cell", cell, first);
        for (int corner = 0; corner < corners; ++corner) {
            scanner.stay_on_line("a cell");
            numbers.push_back(scanner.vertex(nodes.size(), nodes.first));
        }
        for (int node = 0; node < extras.nodes; ++node)
            scanner.vertex(nodes.size(), nodes.first);
        groups.push_back(read_attributes(scanner, extras.attributes));
        for (int word = 0; word < extras.neighbors && !scanner.at_line_end(); ++word)
            scanner.word("a neighbor");
        scanner.end_line("a cell");
    }
    end_records(scanner, count, "cells");
    const auto tags = cells.tags_from(groups, groups.size());
    for (Index cell = 0; cell < count; ++cell) {
        cells.add(corners - 1, std::span(numbers).subspan(cell * corners, corners), tags[cell]);
        cells.leave_out_nodes(extras.nodes);
    }
}

/// The first line of .ele: number of cells, of corners, of attributes. TetGen's cells have 4
/// corners, those of its planar sister Triangle 3.
void add_elements(CellLists& cells, const Nodes& nodes, const SourceFile& file) {
    Scanner scanner(file.name, file.text, syntax);
    const Index count = scanner.count("cells", 0);
    const auto linear = nodes.points.cols() + 1;
    const auto nodes_of_each =
        scanner.at_line_end() ? linear : scanner.integer("the number of corners");
    const int corners = nodes_of_each == 3 || nodes_of_each == 6 ? 3 : 4;
    const auto extra = nodes_of_each - corners;
    if (corners > linear || (extra != 0 && extra != corners * (corners - 1) / 2))
        scanner.fail(fmt::format("cells of {} corners; expected {}, the corners of a simplex, or "
                                 "those and a node on each edge; export it again",
                                 nodes_of_each, linear));
    const auto attributes = scanner.at_line_end() ? 0 : scanner.integer("the number of attributes");
    if (attributes < 0 || attributes > std::numeric_limits<int>::max())
        scanner.fail(fmt::format("{} attributes; expected 0 or more; correct it", attributes));
    scanner.as_count(count, "cells", 2 * (static_cast<std::size_t>(nodes_of_each) + 1));
    scanner.next_line();
    add_cells(cells, nodes, scanner, count, corners,
              {.nodes = static_cast<int>(extra), .attributes = static_cast<int>(attributes)});
}

/// The number of words in the next line that has some.
Index words_in_line(Scanner scanner) {
    Index words = 0;
    for (bool ends = scanner.at_end(); !ends; ends = scanner.at_line_end(), ++words)
        scanner.word("a number");
    return words;
}

/// Whether the word behind the ends of each edge is a node on it, which sees them at an obtuse
/// angle. A marker and a neighbor are two words as well.
bool have_nodes(Scanner scanner, const Nodes& nodes, Index edges) {
    for (Index edge = 0; edge < edges; ++edge, scanner.next_line()) {
        scanner.word("the number of a cell");
        const Index a = scanner.vertex(nodes.size(), nodes.first);
        const Index b = scanner.vertex(nodes.size(), nodes.first);
        const double node = scanner.at_line_end() ? -1 : scanner.number("a node") - nodes.first;
        if (!(node >= 0 && node < nodes.size()) || node != std::floor(node))
            return false;
        const auto place = nodes.points.row(static_cast<Index>(node));
        if ((place - nodes.points.row(a)).dot(place - nodes.points.row(b)) >= 0)
            return false;
    }
    return true;
}

/// The first line of .face and .edge: number of cells, whether they have markers. The option -o2 of
/// TetGen appends the nodes on the sides of a cell to its corners, -nn the tetrahedra beside it.
void add_faces(CellLists& cells, const Nodes& nodes, int corners, const SourceFile& file) {
    Scanner scanner(file.name, file.text, syntax);
    const Index count = scanner.count("cells", 0);
    const int markers = scanner.at_line_end() || scanner.integer("the number of markers") != 0;
    scanner.as_count(count, "cells", 2 * (static_cast<std::size_t>(corners) + 1));
    scanner.next_line();
    const Index sides = corners * (corners - 1) / 2;
    const bool has_nodes = words_in_line(scanner) >= 1 + corners + sides + markers &&
                           (corners == 3 || have_nodes(scanner, nodes, count));
    add_cells(cells, nodes, scanner, count, corners,
              {.nodes = has_nodes ? sides : 0, .attributes = markers, .neighbors = 2});
}

/// In capital letters where the file's own extension has no others.
std::filesystem::path with_extension(std::filesystem::path path, std::string extension) {
    const auto own = path.extension().string();
    if (std::none_of(own.begin(), own.end(), [](char c) { return c >= 'a' && c <= 'z'; }))
        std::transform(extension.begin(), extension.end(), extension.begin(),
                       [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
    return path.replace_extension(extension);
}

/// The files of cells of this mesh, one of which may be this file.
std::vector<SourceFile> cells_beside(const SourceFile& file) {
    std::vector<SourceFile> files;
    for (const char* extension : {".ele", ".face", ".edge"}) {
        const auto cells = with_extension(file.name, extension);
        std::error_code none;
        if (lower_extension(file.name) == extension)
            files.push_back(file);
        else if (std::filesystem::exists(cells, none))
            files.push_back(read_source_file(cells));
    }
    if (files.empty())
        refuse_contents(file.name,
                        fmt::format("there is neither {} nor .face nor .edge in the same folder; "
                                    "expected the file of the cells; add it",
                                    with_extension(file.name, ".ele").string()));
    return files;
}

} // namespace

Mesh parse_tetgen(const SourceFile& nodes, const std::vector<SourceFile>& files) {
    Nodes read = read_nodes(nodes);
    CellLists cells;
    for (const SourceFile& file : files)
        if (const auto extension = lower_extension(file.name); extension == ".ele")
            add_elements(cells, read, file);
        else
            add_faces(cells, read, extension == ".face" ? 3 : 2, file);
    return std::move(cells).mesh(std::move(read.points), nodes);
}

Mesh read_tetgen(const SourceFile& file) {
    const bool has_nodes = lower_extension(file.name) == ".node";
    return parse_tetgen(has_nodes ? file : read_source_file(with_extension(file.name, ".node")),
                        cells_beside(file));
}

} // namespace polydec
