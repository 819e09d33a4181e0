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

Points read_points(Scanner& scanner, Index count, Index ambient) {
    const auto record = fmt::format("a vertex of {} coordinates", ambient);
    Points points(count, ambient);
    for (Index vertex = 0; vertex < count; ++vertex) {
        points(vertex, 0) = scanner.coordinate(vertex);
        for (Index axis = 1; axis < ambient; ++axis) {
            scanner.stay_on_line(record);
            points(vertex, axis) = scanner.coordinate(vertex);
        }
        scanner.end_line(record);
    }
    return points;
}

} // namespace

Simplices read_simplices(Scanner& scanner, Index count, Index dimension, Index vertices) {
    const auto record = fmt::format("a simplex of {} vertex numbers", dimension + 1);
    Simplices simplices(count, dimension + 1);
    for (Index simplex = 0; simplex < count; ++simplex) {
        simplices(simplex, 0) = scanner.vertex(vertices, 0);
        for (Index corner = 1; corner <= dimension; ++corner) {
            scanner.stay_on_line(record);
            simplices(simplex, corner) = scanner.vertex(vertices, 0);
        }
        scanner.end_line(record);
    }
    return simplices;
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
    mesh.points = read_points(scanner, vertices, ambient);
    mesh.simplices = read_simplices(scanner, simplices, dimension, vertices);
    if (!scanner.at_end())
        scanner.fail(fmt::format("more follows after {} simplices; expected the end of the file; "
                                 "correct the number in the first line",
                                 simplices));
    return mesh;
}

} // namespace polydec
