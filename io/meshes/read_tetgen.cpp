// SPDX-License-Identifier: MIT
#include "io/meshes/cell_lists.h"
#include "io/meshes/readers.h"
#include "io/scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <system_error>
#include <utility>

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

/// The cells, one a line: number, corners, extras.
Mesh read_cells(Scanner& scanner, Nodes nodes, Index count, int corners, const Extras& extras) {
    scanner.as_count(
        count, "cells",
        2 * (static_cast<std::size_t>(corners) + static_cast<std::size_t>(extras.nodes) + 1));
    scanner.next_line();
    Mesh mesh;
    mesh.simplices.resize(count, corners);
    std::vector<double> regions(count);

    const auto first = first_number(scanner, "cell");
    for (Index cell = 0; cell < count; ++cell) {
        read_number(scanner, "cell", cell, first);
        for (int corner = 0; corner < corners; ++corner) {
            scanner.stay_on_line("a cell");
            mesh.simplices(cell, corner) = scanner.vertex(nodes.size(), nodes.first);
        }
        for (int node = 0; node < extras.nodes; ++node)
            scanner.vertex(nodes.size(), nodes.first);
        regions[cell] = read_attributes(scanner, extras.attributes);
        for (int word = 0; word < extras.neighbors && !scanner.at_line_end(); ++word)
            scanner.word("a neighbor");
        scanner.end_line("a cell");
    }
    mesh.tags = tags_or_none(tags_from(regions));
    if (extras.nodes > 0 && count > 0)
        mesh.warnings.push_back(higher_order_warning(count));
    mesh.points = std::move(nodes.points);
    return mesh;
}

/// The first line of .ele: number of cells, of corners, of attributes. TetGen's cells have 4
/// corners, those of its planar sister Triangle 3.
Mesh read_elements(Nodes nodes, const SourceFile& file) {
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
    return read_cells(
        scanner, std::move(nodes), count, corners,
        {.nodes = static_cast<int>(extra), .attributes = static_cast<int>(attributes)});
}

/// The option -nn of TetGen appends the tetrahedra on both sides of a face.
Mesh read_faces(Nodes nodes, const SourceFile& file) {
    Scanner scanner(file.name, file.text, syntax);
    const Index count = scanner.count("cells", 0);
    return read_cells(scanner, std::move(nodes), count, 3, {.attributes = 1, .neighbors = 2});
}

/// In capital letters where the file's own extension has no others.
std::filesystem::path with_extension(std::filesystem::path path, std::string extension) {
    const auto own = path.extension().string();
    if (std::none_of(own.begin(), own.end(), [](char c) { return c >= 'a' && c <= 'z'; }))
        std::transform(extension.begin(), extension.end(), extension.begin(),
                       [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
    return path.replace_extension(extension);
}

/// The file that holds the cells of these vertices.
std::filesystem::path cells_beside(const std::filesystem::path& path) {
    for (const char* extension : {".ele", ".face"}) {
        auto cells = with_extension(path, extension);
        std::error_code none;
        if (std::filesystem::exists(cells, none))
            return cells;
    }
    refuse_contents(path.string(), fmt::format("there is neither {} nor .face in the same folder; "
                                               "expected the file of the cells; add it",
                                               with_extension(path, ".ele").string()));
}

} // namespace

Mesh parse_tetgen(const SourceFile& nodes, const SourceFile& cells) {
    auto points = read_nodes(nodes);
    return lower_extension(cells.name) == ".face" ? read_faces(std::move(points), cells)
                                                  : read_elements(std::move(points), cells);
}

Mesh read_tetgen(const SourceFile& file) {
    if (lower_extension(file.name) == ".node")
        return parse_tetgen(file, read_source_file(cells_beside(file.name)));
    return parse_tetgen(read_source_file(with_extension(file.name, ".node")), file);
}

} // namespace polydec
