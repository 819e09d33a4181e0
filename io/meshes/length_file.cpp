// SPDX-License-Identifier: MIT
#include "io/meshes/mesh_files.h"
#include "io/meshes/readers.h"
#include "io/number_lines.h"
#include "io/scanner.h"

#include <fmt/format.h>

#include <cmath>
#include <new>
#include <string>
#include <vector>

namespace polydec {

namespace {

bool is_length(double value) {
    return value > 0 && std::isfinite(value);
}

/// Reads the edges with their lengths; gives the line of each.
std::vector<std::size_t> read_edges(Scanner& scanner, Index count, LengthMesh& mesh) {
    const std::string record = "an edge: two vertex numbers and a length";
    mesh.edges.resize(count, 2);
    mesh.lengths.resize(count);
    std::vector<std::size_t> lines(count);
    for (Index edge = 0; edge < count; ++edge) {
        const Index a = mesh.edges(edge, 0) = scanner.vertex(mesh.vertices, 0);
        lines[edge] = scanner.line();
        scanner.stay_on_line(record);
        const Index b = mesh.edges(edge, 1) = scanner.vertex(mesh.vertices, 0);
        scanner.stay_on_line(record);
        const double length = mesh.lengths[edge] = scanner.number("a length");
        if (!is_length(length))
            scanner.fail(fmt::format("edge {} {} has length {}; expected a finite number above 0; "
                                     "correct it",
                                     a, b, length));
        scanner.end_line(record);
    }
    return lines;
}

void check_edges(Scanner& scanner, const LengthMesh& mesh, const std::vector<std::size_t>& lines) {
    const auto fault = edge_fault(mesh);
    if (!fault)
        return;
    const auto line = [&](Index row) { return lines[row]; };
    const auto name = fmt::format("edge {} {}", fault->a, fault->b);
    if (fault->kind == EdgeFault::Kind::missing)
        refuse_contents(
            std::string(scanner.name()),
            fmt::format(
                "{} of the simplices has no length; expected each edge once; add a line for it",
                name),
            {.degree = 1, .vertices = {fault->a, fault->b}});
    scanner.set_line(line(fault->row));
    if (fault->kind == EdgeFault::Kind::repeated)
        scanner.fail(fmt::format("{} already has a length on line {}; expected each edge once; "
                                 "remove one of the two lines",
                                 name, line(fault->previous)));
    scanner.fail(fmt::format("{} belongs to no simplex; expected edges of the simplices; remove "
                             "the line or correct its vertices",
                             name));
}

} // namespace

bool is_length_file(const std::filesystem::path& path) {
    return lower_extension(path) == ".nsl";
}

LengthMesh parse_lengths(const SourceFile& file) {
    Scanner scanner(file.name, file.text, {.comment = '#'});
    const std::size_t bytes = 2; // a digit and what separates it
    const Index dimension = scanner.count("dimensions", bytes);
    if (dimension < 1)
        scanner.fail(fmt::format("dimension {}; expected at least 1; the first line is n V S E: "
                                 "dimension and numbers of vertices, simplices and edges",
                                 dimension));
    LengthMesh mesh;
    mesh.vertices = scanner.count("vertices", bytes);
    const Index simplices =
        scanner.count("simplices", bytes * (static_cast<std::size_t>(dimension) + 1));
    const Index edges = scanner.count("edges", 3 * bytes);
    scanner.end_line("the first line, n V S E: dimension and numbers of vertices, simplices and "
                     "edges");
    try {
        mesh.simplices = read_simplices(scanner, simplices, dimension, mesh.vertices);
        const auto lines = read_edges(scanner, edges, mesh);
        end_records(scanner, edges, "edges");
        if (simplices == 0)
            refuse_contents(file.name,
                            "the file holds no simplices; expected at least one; write it again");
        check_edges(scanner, mesh, lines);
    } catch (const std::bad_alloc&) {
        refuse_reading(file.name, "not enough memory");
    }
    return mesh;
}

LengthMesh read_lengths(const std::filesystem::path& path) {
    if (!is_length_file(path))
        refuse_contents(path.string(), "read_lengths reads edge lengths from .nsl files; rename "
                                       "the file, or read it with read_mesh");
    return parse_lengths(read_source_file(path));
}

void write_lengths(const std::filesystem::path& path, const LengthMesh& mesh) {
    if (!is_length_file(path))
        refuse_writing(path, "edge lengths need a file with the extension .nsl");
    check(mesh);
    for (Index e = 0; e < mesh.edges.rows(); ++e)
        if (!is_length(mesh.lengths[e]))
            refuse_writing(
                path,
                fmt::format("edge {} with vertices {} and {} has length {}; expected a finite "
                            "number above 0",
                            e, mesh.edges(e, 0), mesh.edges(e, 1), mesh.lengths[e]),
                {.degree = 1, .cells = {e}, .vertices = {mesh.edges(e, 0), mesh.edges(e, 1)}});
    NumberLines lines(path);
    lines.text(fmt::format("{} {} {} {}\n", mesh.dimension(), mesh.vertices, mesh.simplices.rows(),
                           mesh.edges.rows()));
    for (Index s = 0; s < mesh.simplices.rows(); ++s) {
        lines.numbers(mesh.simplices.row(s));
        lines.end();
    }
    for (Index e = 0; e < mesh.edges.rows(); ++e)
        lines.line(mesh.edges(e, 0), mesh.edges(e, 1), mesh.lengths[e]);
    lines.commit();
}

} // namespace polydec
