// SPDX-License-Identifier: MIT
#include "io/pictures/draw_cells.h"

#include "base/checks.h"
#include "base/errors.h"
#include "complex/corners.h"
#include "dec/fields/transfer.h"
#include "dec/forms/star.h"
#include "dec/metric/simplex_metric.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace polydec {

namespace {

/// The volume that a closed surface of polygons encloses, positive if they are oriented outward.
double enclosed_volume(const Points& points, const std::vector<std::vector<Index>>& faces) {
    double sixfold = 0.0;
    const Eigen::RowVector3d origin = points.row(faces.front().front());
    for (const auto& face : faces)
        for (std::size_t i = 2; i < face.size(); ++i) {
            const Eigen::RowVector3d a = points.row(face[0]) - origin;
            const Eigen::RowVector3d b = points.row(face[i - 1]) - origin;
            const Eigen::RowVector3d c = points.row(face[i]) - origin;
            sixfold += a.dot(b.cross(c));
        }
    return sixfold / 6.0;
}

/// The faces of a 3-cell, oriented outward.
std::vector<std::vector<Index>> outward_faces(const Points& points, const Merging& merging,
                                              Index cell) {
    std::vector<std::vector<Index>> faces;
    for (IncidenceMatrix::InnerIterator face(merging.merged().coboundary(2), cell); face; ++face) {
        faces.push_back(corners(merging, static_cast<Index>(face.col())));
        if (face.value() < 0)
            std::reverse(faces.back().begin(), faces.back().end());
    }
    if (enclosed_volume(points, faces) < 0.0)
        for (auto& face : faces)
            std::reverse(face.begin(), face.end());
    return faces;
}

void draw_cell(VtuGrid& grid, const Merging& merging, int k, Index cell) {
    if (k == 1)
        add_cell(grid, VtuCell::line, merging.vertices(1, cell));
    else if (k == 2)
        add_cell(grid, VtuCell::polygon, corners(merging, cell));
    else
        add_polyhedron(grid, outward_faces(grid.points, merging, cell));
}

} // namespace

void check_drawable(int dimension, int ambient_dimension) {
    require_points(ambient_dimension, "a drawing");
    if (dimension > 3 || ambient_dimension > 3)
        throw InvalidInput(fmt::format("cells of dimension {} in {} coordinates cannot be drawn: a "
                                       ".vtu file shows at most 3",
                                       dimension, ambient_dimension));
}

VtuGrid draw_cells(const Merging& merging, const Points& points, int k) {
    cell_degree(merging.merged(), Side::primal, k);
    const int drawn = k == 0 ? merging.merged().dimension() : k;
    check_drawable(drawn, static_cast<int>(points.cols()));
    VtuGrid grid;
    grid.points = points;
    for (Index cell = 0; cell < merging.merged().size(drawn); ++cell)
        draw_cell(grid, merging, drawn, cell);
    return grid;
}

void add_cochain(VtuGrid& grid, const Merging& merging, int k, std::string name,
                 const Eigen::Ref<const DenseMatrix>& values) {
    cell_degree(merging.merged(), Side::primal, k);
    check_as_many(fmt::format("rows of `{}`", name), values.rows(), merging.merged().size(k));
    if (k > 0) {
        grid.cell_data.push_back(vtu_array(std::move(name), values));
        return;
    }
    const auto& vertices = merging.pieces().simplices(0);
    check_number("the point", vertices.maxCoeff(), 0, grid.points.rows() - 1);
    DenseMatrix at_points = DenseMatrix::Zero(grid.points.rows(), values.cols());
    for (Index v = 0; v < vertices.rows(); ++v)
        at_points.row(vertices(v, 0)) = values.row(v);
    grid.point_data.push_back(vtu_array(std::move(name), at_points));
}

namespace {

/// Cells whose corners have points: those of the input where edges were flipped.
Merging drawn(const Discretization& discretization) {
    return discretization.passage.is_identity() ? discretization.merging
                                                : unmerged(discretization.input());
}

} // namespace

VtuGrid draw_cells(const Discretization& discretization, int k) {
    auto grid = draw_cells(drawn(discretization), discretization.points, k);
    grid.points *= discretization.unit;
    return grid;
}

void add_form(VtuGrid& grid, const Discretization& discretization, std::string name,
              const Cochain& form) {
    const int k = cell_degree(discretization.complex(), form.side, form.degree);
    check(discretization.complex(), form);
    if (discretization.passage.is_identity())
        return add_cochain(grid, discretization.merging, k, std::move(name), form.values);
    Cochain shown = form;
    if (form.side == Side::dual && k < discretization.dimension())
        shown = {Side::primal, k,
                 star(discretization.volumes, k).cwiseInverse().cwiseProduct(form.values)};
    add_cochain(grid, drawn(discretization), k, std::move(name),
                to_input(discretization, shown).values);
}

PolygonMesh polygon_mesh(const Merging& merging, const Points& points) {
    require_points(points.cols(), "a drawing");
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
