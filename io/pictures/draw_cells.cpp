// SPDX-License-Identifier: MIT
#include "io/pictures/draw_cells.h"

#include "base/checks.h"
#include "base/errors.h"
#include "complex/merging.h"
#include "dec/discretization/glued_box.h"
#include "dec/fields/flat_and_sharp.h"
#include "dec/fields/transfer.h"
#include "dec/metric/simplex_metric.h"
#include "dec/stars/star.h"
#include "dec/surfaces/passage.h"
#include "io/pictures/vtu_solids.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <functional>
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

/// The corners of a 2-cell, in the order of its boundary.
using Rings = std::function<std::vector<Index>(Index)>;

/// The faces of a 3-cell, oriented outward.
std::vector<std::vector<Index>> outward_faces(const CellComplex& complex, const Points& points,
                                              const Rings& ring, Index cell) {
    std::vector<std::vector<Index>> faces;
    for (const auto& [face, sign] : complex.incidences(2)[cell]) {
        faces.push_back(ring(face));
        if (sign < 0)
            std::reverse(faces.back().begin(), faces.back().end());
    }
    if (enclosed_volume(points, faces) < 0.0)
        for (auto& face : faces)
            std::reverse(face.begin(), face.end());
    return faces;
}

/// The ends of an edge.
std::vector<Index> ends(const CellComplex& complex, Index edge) {
    std::vector<Index> list;
    for (const SignedFace& end : complex.incidences(0)[edge])
        list.push_back(end.face);
    if (list.size() != 2)
        throw InvalidInput(fmt::format("edge {} is a loop: it cannot be drawn", edge),
                           {.degree = 1, .cells = {edge}});
    return list;
}

/// What stands for some vertices in the picture.
using Naming = std::function<std::vector<Index>(std::vector<Index>)>;

/// With tetrahedra and hexahedra, if all cells are such, else with polyhedra alone: readers of
/// VTK's files know either.
VtuGrid with_solids(VtuGrid grid, Index count,
                    const std::function<std::vector<std::vector<Index>>(Index)>& faces) {
    VtuGrid simple = grid;
    Index cell = 0;
    while (cell < count && add_simple_solid(simple, faces(cell)))
        ++cell;
    if (cell == count)
        return simple;
    for (cell = 0; cell < count; ++cell)
        add_polyhedron(grid, faces(cell));
    return grid;
}

/// The cells that carry k-forms; the points of the grid are those of the vertices, in their order.
VtuGrid draw(const CellComplex& complex, const Points& points, int k, const Rings& ring,
             const Naming& named) {
    cell_degree(complex, Side::primal, k);
    const int drawn = k == 0 ? complex.dimension() : k;
    check_drawable(drawn, static_cast<int>(points.cols()));
    check_as_many("points", points.rows(), complex.size(0));
    VtuGrid grid;
    grid.points = points;
    const Index count = complex.size(drawn);
    const auto faces = [&](Index cell) {
        auto list = outward_faces(complex, points, ring, cell);
        std::transform(list.begin(), list.end(), list.begin(), named);
        return list;
    };
    if (drawn > 2)
        return with_solids(std::move(grid), count, faces);
    for (Index cell = 0; cell < count; ++cell)
        if (drawn == 1)
            add_cell(grid, VtuCell::line, named(ends(complex, cell)));
        else
            add_polygon(grid, named(ring(cell)));
    return grid;
}

PolygonMesh polygons(const Merging& merging, Points points, const Naming& named) {
    PolygonMesh mesh;
    mesh.points = std::move(points);
    for (Index cell = 0; cell < merging.merged().size(2); ++cell)
        mesh.add(named(corners(merging, cell)));
    return mesh;
}

/// Rows of the input's vertices where its numbers say, those of vertices of no cell between them.
Points by_number(const Discretization& mesh, const Points& rows, const Points& others) {
    Points result(rows.rows() + others.rows(), rows.cols());
    Index v = 0, isolated = 0;
    for (Index i = 0; i < result.rows(); ++i)
        result.row(i) = v < rows.rows() && mesh.input().vertex_number(v) == i
                            ? rows.row(v++)
                            : others.row(isolated++);
    return result;
}

/// The points of the input, by its numbers and in its units.
Points points_of_input(const Discretization& mesh) {
    return by_number(mesh, mesh.input_points(), mesh.isolated());
}

/// By these numbers.
Naming numbers_of_input(const Discretization& mesh) {
    return
        [&mesh](std::vector<Index> list) { return mesh.input().vertex_numbers(std::move(list)); };
}

Vector drawn_values(const Discretization& given, const Cochain& form) {
    const int k = cell_degree(given.complex(), form.side, form.degree);
    check(given.complex(), form);
    Cochain shown = form_at_places(given, form);
    const Discretization& mesh = placed(given);
    if (!mesh.passage().is_identity()) {
        if (form.side == Side::dual && k < mesh.dimension())
            shown = {Side::primal, k,
                     star(mesh.volumes(), k).diagonal().cwiseInverse().cwiseProduct(form.values)};
        shown = to_input(mesh, shown);
    }
    if (k == 0)
        shown.values = by_number(mesh, shown.values, Vector::Zero(mesh.isolated().rows()));
    return shown.values;
}

} // namespace

void check_drawable(int dimension, int ambient_dimension) {
    require_points(ambient_dimension, "a drawing");
    if (dimension > 3 || ambient_dimension > 3)
        throw InvalidInput(fmt::format("cells of dimension {} in {} coordinates cannot be drawn: a "
                                       ".vtu file shows at most 3",
                                       dimension, ambient_dimension));
}

VtuGrid draw_cells(const CellComplex& complex, const Points& points, int k) {
    return draw(
        complex, points, k, [&](Index cell) { return corners(complex, cell); }, std::identity());
}

void add_cochain(VtuData& picture, const CellComplex& complex, int k, std::string name,
                 const Eigen::Ref<const DenseMatrix>& values) {
    cell_degree(complex, Side::primal, k);
    check_as_many(fmt::format("rows of `{}`", name), values.rows(), complex.size(k));
    (k > 0 ? picture.cell_data : picture.point_data).push_back(vtu_array(std::move(name), values));
}

Merging drawn_cells(const Discretization& given) {
    const Discretization& mesh = placed(given);
    return mesh.passage().is_identity() ? mesh.merging() : Merging(mesh.input());
}

VtuGrid draw_cells(const Discretization& given, int k) {
    const Discretization& mesh = placed(given);
    const Merging cells = drawn_cells(mesh);
    auto grid = draw(
        cells.merged(), mesh.input_points(), k, [&](Index cell) { return corners(cells, cell); },
        numbers_of_input(mesh));
    grid.points = points_of_input(mesh);
    return grid;
}

DenseMatrix drawn_values(const Discretization& given, Side side, int degree,
                         const Eigen::Ref<const DenseMatrix>& columns) {
    DenseMatrix result;
    for (Eigen::Index i = 0; i < columns.cols(); ++i) {
        const Vector column = drawn_values(given, {side, degree, columns.col(i)});
        result.conservativeResize(column.size(), columns.cols());
        result.col(i) = column;
    }
    return result;
}

bool add_vectors(VtuData& picture, const Discretization& mesh, const std::string& name,
                 const Cochain& form) {
    try {
        const DenseMatrix vectors = vectors_at_vertices(mesh, form);
        if (vectors.rows() > 0)
            picture.point_data.push_back(
                vtu_array(name + "_vector", drawn_values(mesh, Side::primal, 0, vectors)));
        return vectors.rows() > 0;
    } catch (const InvalidInput&) {
        return false;
    }
}

PolygonMesh polygon_mesh(const Merging& merging, const Points& points) {
    require_points(merging.pieces(), points, "a drawing");
    return polygons(merging, points, std::identity());
}

PolygonMesh polygon_mesh(const Discretization& given) {
    const Discretization& mesh = placed(given);
    require_points(mesh.ambient_dimension(), "a drawing");
    if (mesh.passage().is_identity())
        return polygons(mesh.merging(), points_of_input(mesh), numbers_of_input(mesh));
    Overlay pieces = overlay(mesh.passage(), mesh.measured_points());
    return {mesh.unit() * pieces.points, std::move(pieces.corners), std::move(pieces.offsets)};
}

} // namespace polydec
