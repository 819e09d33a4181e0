// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "complex/components.h"
#include "dec/fields/cell_centers.h"
#include "dec/fields/chosen_cells.h"
#include "dec/metric/simplex_metric.h"

#include <fmt/format.h>

#include <algorithm>

namespace polydec {

namespace {

std::vector<Index> numbers_of(const std::vector<bool>& marks) {
    std::vector<Index> numbers;
    for (std::size_t v = 0; v < marks.size(); ++v)
        if (marks[v])
            numbers.push_back(static_cast<Index>(v));
    return numbers;
}

/// The vertices of the marked k-cells.
std::vector<Index> vertices_of(const CellComplex& complex, int k, const std::vector<bool>& cells) {
    CellMarks marks = no_marks(complex);
    marks[k] = cells;
    mark_faces(complex, marks);
    return numbers_of(marks[0]);
}

} // namespace

std::vector<Index> boundary_vertices(const Discretization& mesh) {
    auto numbers = numbers_of(boundary_cells(mesh.complex())[0]);
    if (numbers.empty())
        throw InvalidInput(
            "the mesh has no boundary, and so no boundary vertices: choose other vertices");
    return numbers;
}

std::vector<Index> vertices_where(const Discretization& mesh,
                                  const std::function<bool(const Vector& point)>& predicate) {
    require_points(mesh.ambient_dimension(), "a vertex chosen by its place");
    const Points points = cell_centers(mesh, 0);
    std::vector<bool> marks;
    for (Index v = 0; v < points.rows(); ++v)
        marks.push_back(predicate(points.row(v).transpose()));
    auto numbers = numbers_of(marks);
    if (numbers.empty())
        throw InvalidInput(
            fmt::format("the predicate holds at none of the {} vertices: expected at least one",
                        points.rows()));
    return numbers;
}

std::vector<Index> vertices_on(const Discretization& mesh, const std::vector<std::string>& groups) {
    const int n = mesh.dimension();
    std::vector<bool> marks(mesh.complex().size(0), false);
    for (const auto& group : groups) {
        std::vector<bool> cells;
        const auto tag = group_tag(mesh.groups(), n, group);
        for (const Index of_cell : mesh.tags())
            cells.push_back(tag && of_cell == *tag);
        const bool of_cells = std::find(cells.begin(), cells.end(), true) != cells.end();
        for (const Index v : of_cells
                                 ? vertices_of(mesh.complex(), n, cells)
                                 : vertices_of(mesh.complex(), n - 1, facets_in(mesh, {group})))
            marks[v] = true;
    }
    return numbers_of(marks);
}

} // namespace polydec
