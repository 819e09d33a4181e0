// SPDX-License-Identifier: MIT
#include "io/draw_cells.h"

#include "base/errors.h"
#include "complex/corners.h"

#include <fmt/format.h>

#include <utility>

namespace polydec {

namespace {

void draw_cell(VtuGrid& grid, const Merging& merging, int k, Index cell) {
    switch (k) {
    case 1:
        add_cell(grid, VtuCell::line, merging.vertices(1, cell));
        break;
    case 2:
        add_cell(grid, VtuCell::polygon, corners(merging, cell));
        break;
    default: {
        std::vector<std::vector<Index>> faces;
        for (IncidenceMatrix::InnerIterator face(merging.merged().coboundary(2), cell); face;
             ++face)
            faces.push_back(corners(merging, static_cast<Index>(face.col())));
        add_polyhedron(grid, faces);
    }
    }
}

} // namespace

void check_drawable(int dimension, int ambient_dimension) {
    if (dimension > 3 || ambient_dimension > 3)
        throw InvalidInput(fmt::format("cells of dimension {} in {} coordinates cannot be drawn: a "
                                       ".vtu file shows at most 3; leave out -o",
                                       dimension, ambient_dimension));
}

VtuGrid draw_cells(const Merging& merging, const Points& points, int k) {
    const int drawn = k == 0 ? merging.merged().dimension() : k;
    check_drawable(drawn, static_cast<int>(points.cols()));
    VtuGrid grid;
    grid.points = points;
    for (Index cell = 0; cell < merging.merged().size(drawn); ++cell)
        draw_cell(grid, merging, drawn, cell);
    return grid;
}

void add_cochain(VtuGrid& grid, const Merging& merging, int k, std::string name,
                 const Vector& values) {
    if (k > 0) {
        grid.cell_data.push_back(vtu_array(std::move(name), values));
        return;
    }
    const auto& vertices = merging.input().simplices(0);
    Vector at_points = Vector::Zero(grid.points.rows());
    for (Index v = 0; v < vertices.rows(); ++v)
        at_points[vertices(v, 0)] = values[v];
    grid.point_data.push_back(vtu_array(std::move(name), at_points));
}

PolygonMesh polygon_mesh(const Merging& merging, const Points& points) {
    PolygonMesh mesh;
    mesh.points = points;
    for (Index cell = 0; cell < merging.merged().size(2); ++cell) {
        const auto polygon = corners(merging, cell);
        mesh.corners.insert(mesh.corners.end(), polygon.begin(), polygon.end());
        mesh.offsets.push_back(static_cast<Index>(mesh.corners.size()));
    }
    return mesh;
}

} // namespace polydec
