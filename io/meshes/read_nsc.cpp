// SPDX-License-Identifier: MIT
#include "io/meshes/readers.h"
#include "io/scanner.h"

#include <fmt/format.h>

namespace polydec {

namespace {

void check_dimensions(const Scanner& scanner, Index ambient, Index dimension) {
    if (dimension < 1 || dimension > ambient)
        scanner.fail(fmt::format("dimension {} in ambient dimension {}; expected 1 <= n <= N; the "
                                 "first line is N n, then the numbers of vertices and simplices",
                                 dimension, ambient));
}

/// Rows of so many numbers, one a line.
template <class Rows, class Read>
Rows read_rows(Scanner& scanner, Index count, Index width, const std::string& record, Read read) {
    Rows rows(count, width);
    for (Index row = 0; row < count; ++row) {
        for (Index column = 0; column < width; ++column) {
            if (column > 0)
                scanner.stay_on_line(record);
            rows(row, column) = read(row);
        }
        scanner.end_line(record);
    }
    return rows;
}

} // namespace

Simplices read_simplices(Scanner& scanner, Index count, Index dimension, Index vertices) {
    return read_rows<Simplices>(scanner, count, dimension + 1,
                                fmt::format("a simplex of {} vertex numbers", dimension + 1),
                                [&](Index) { return scanner.vertex(vertices, 0); });
}

Mesh read_nsc(const SourceFile& file) {
    Scanner scanner(file.name, file.text, {.comment = '#'});
    const Index ambient = scanner.count("coordinates of a vertex", 2);
    const Index dimension = scanner.count("dimensions", 2);
    check_dimensions(scanner, ambient, dimension);
    const std::size_t bytes = 2;
    const Index vertices = scanner.count("vertices", bytes * static_cast<std::size_t>(ambient));
    const Index simplices =
        scanner.count("simplices", bytes * (static_cast<std::size_t>(dimension) + 1));
    scanner.end_line("the first line, N n and the numbers of vertices and simplices");

    Mesh mesh;
    mesh.points = read_rows<Points>(scanner, vertices, ambient,
                                    fmt::format("a vertex of {} coordinates", ambient),
                                    [&](Index vertex) { return scanner.coordinate(vertex); });
    mesh.simplices = read_simplices(scanner, simplices, dimension, vertices);
    end_records(scanner, simplices, "simplices");
    return mesh;
}

} // namespace polydec
