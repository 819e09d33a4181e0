// SPDX-License-Identifier: MIT
#include "shape/shape.h"

#include "base/checks.h"
#include "base/errors.h"
#include "base/lists.h"
#include "complex/surfaces/ordered_surface.h"
#include "dec/surfaces/intrinsic_delaunay.h"
#include "shape/gluing.h"
#include "shape/measured_simplex.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace polydec {

namespace {

void check_weights(const char* what, const Vector& weights, Index simplices) {
    if (weights.size() == 0)
        return;
    check_as_many(what, weights.size(), simplices);
    for (Index s = 0; s < simplices; ++s)
        if (!(weights[s] > 0) || !std::isfinite(weights[s]))
            throw InvalidInput(fmt::format("{} {} of simplex {}: expected a finite positive number",
                                           what, weights[s], s));
}

/// As given, or between the points given: those in their n-plane are rounded once more.
Vector lengths_of(const Discretization& mesh, const Geometry& geometry) {
    const SimplexMetric metric = geometry.metric();
    return metric.points() != nullptr
               ? edge_lengths(geometry.pieces(), mesh.measured_input_points())
               : *metric.lengths();
}

/// The share by which the lengths of a flipped surface may be off: every flip rounds the length of
/// an edge, which others follow from.
double error_of_flips(const IntrinsicDelaunay& flips) {
    constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();
    return rounding + 2 * flips.statistics.added_length / flips.lengths.minCoeff();
}

/// The share by which bisections before may have changed squares of lengths: each rounds the middle
/// of two points, or a median by its triangle's edges, if no parts between were flatter than the
/// last.
double error_of_refining(const Discretization& mesh) {
    if (mesh.bisections() == 0)
        return 0;
    const Shape before{.pieces = mesh.input(), .lengths = lengths_of(mesh, mesh.input_geometry())};
    const Points& points = mesh.measured_input_points();
    const double far = points.cols() > 0 ? points.rowwise().norm().maxCoeff() : 0;
    double worst = 0;
    for (Index s = 0; s < before.pieces.size(mesh.dimension()); ++s) {
        const auto measured = measured_simplex(before, s);
        const double reach = points.cols() > 0
                                 ? far / std::sqrt(measured.shortest_square)
                                 : 4 * measured.longest_square / measured.shortest_square;
        worst = std::max(worst, measured.sensitivity * reach);
    }
    return mesh.bisections() * std::numeric_limits<double>::epsilon() * worst;
}

/// Of each n-simplex; none if there are none.
Vector weights_of(const Discretization& mesh, const CellData& weights, const char* what) {
    if (weights.is_empty())
        return {};
    const Vector of_cells = weights.on(mesh, what, Range::positive);
    const auto& carriers = mesh.merging().carriers(mesh.dimension());
    Vector result(carriers.size());
    for (Eigen::Index s = 0; s < result.size(); ++s)
        result[s] = of_cells[carriers[s].cell];
    return result;
}

/// By the facets and vertices of the pieces; those inside of merged cells do not matter.
BoundaryConditions conditions_of(const Discretization& mesh, BoundaryConditions conditions) {
    if (mesh.merging().is_identity())
        return conditions;
    const auto by_cell = conditions;
    if (const auto& marks = by_cell.fixed_vertices; !marks.empty()) {
        check_as_many("marks of fixed vertices", std::ssize(marks), mesh.complex().size(0));
        const auto& carriers = mesh.merging().carriers(0);
        conditions.fixed_vertices.assign(carriers.size(), false);
        for (std::size_t v = 0; v < carriers.size(); ++v)
            conditions.fixed_vertices[v] = carriers[v].dimension == 0 && marks[carriers[v].cell];
    }
    if (conditions.facets.empty())
        return conditions;
    robin_coefficients(mesh.complex(), conditions); // throws unless there is one for each
    const int k = mesh.dimension() - 1;
    const auto& carriers = mesh.merging().carriers(k);
    conditions.facets.assign(carriers.size(), BoundaryCondition::natural);
    if (by_cell.coefficients.size() > 1)
        conditions.coefficients.assign(carriers.size(), 1);
    for (std::size_t f = 0; f < carriers.size(); ++f)
        if (const auto& [dimension, cell] = carriers[f]; dimension == k) {
            conditions.facets[f] = by_cell.facets[cell];
            if (by_cell.coefficients.size() > 1)
                conditions.coefficients[f] = by_cell.coefficients[cell];
        }
    return conditions;
}

bool is_constant(const Vector& weights) {
    return weights.size() == 0 || weights.minCoeff() == weights.maxCoeff();
}

} // namespace

Shape shape_of(const Discretization& mesh, const BoundaryConditions& conditions,
               const CellData& conductivity, const CellData& density) {
    const Pieces& pieces = mesh.pieces();
    Shape shape{.pieces = pieces,
                .lengths = mesh.unit() * lengths_of(mesh, mesh.geometry()),
                .conditions = conditions_of(mesh, conditions),
                .conductivity = weights_of(mesh, conductivity, "conductivity"),
                .density = weights_of(mesh, density, "density")};
    if (mesh.points().cols() > 0 || mesh.box()) // else the lengths are what is given
        shape.length_error = 4 * std::numeric_limits<double>::epsilon();
    if (!mesh.passage().is_identity())
        shape.length_error = error_of_flips(mesh.passage().flips());
    shape.metric_error = error_of_refining(mesh);
    check(shape);
    return shape;
}

Shape top_forms(const Shape& shape) {
    Shape result = shape;
    result.conditions = exchanged(shape.conditions);
    result.functions = ShapeFunctions::twisted;
    return result;
}

void check(const Shape& shape) {
    const Pieces& pieces = shape.pieces;
    const int n = pieces.dimension();
    SimplexMetric(pieces, shape.lengths); // throws for lengths that are none
    check_weights("conductivity", shape.conductivity, pieces.size(n));
    check_weights("density", shape.density, pieces.size(n));
    const auto& fixed = shape.conditions.fixed_vertices;
    if (!fixed.empty())
        check_as_many("marks of fixed vertices", std::ssize(fixed), pieces.size(0));
    if (std::find(fixed.begin(), fixed.end(), true) != fixed.end())
        throw InvalidInput("a vertex has a given value, but functions on a shape have no values at "
                           "points: give conditions on facets");
    if (const double error = shape.length_error; !(error >= 0 && error < 0.1))
        throw InvalidInput(fmt::format(
            "the relative error of lengths is {}: expected a number from 0 to 0.1", error));
    if (const double error = shape.metric_error; !(error >= 0))
        throw InvalidInput(fmt::format(
            "the relative error of squared lengths is {}: expected a number of at least 0", error));
    facet_sides(shape); // throws for wrong conditions, and where twisted functions branch
}

FlippedShape flipped(const Shape& shape) {
    check(shape);
    const Pieces& pieces = shape.pieces;
    if (pieces.dimension() != Triangles::dimension || !GluedSurface::accepts(pieces) ||
        !is_constant(shape.conductivity) || !is_constant(shape.density))
        return {shape};
    const auto flips = intrinsic_delaunay(GluedSurface(pieces), shape.lengths);
    if (flips.statistics.flips == 0 && flips.statistics.added_length == 0)
        return {shape};
    Shape result = shape;
    result.pieces =
        in_order(flips.surface, pieces.vertex_numbers(numbers_below(pieces.size(0)))).pieces;
    result.lengths = flips.lengths;
    result.length_error = 0;
    result.metric_error = metric_share(shape) + error_of_flips(flips) * most_sensitivity(result);
    return {std::move(result), flips.statistics.flips};
}

} // namespace polydec
