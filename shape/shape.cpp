// SPDX-License-Identifier: MIT
#include "shape/shape.h"

#include "base/checks.h"
#include "base/errors.h"

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
            throw InvalidInput(fmt::format("{} {} of simplex {}: expected a positive number", what,
                                           weights[s], s));
}

/// The share by which the lengths of a flipped surface may be off.
double error_of_flips(const IntrinsicDelaunay& flips) {
    constexpr double rounding = 64 * std::numeric_limits<double>::epsilon();
    return rounding + 2 * flips.statistics.added_length / flips.lengths.minCoeff();
}

/// Of each n-simplex; none if there are none.
Vector weights_of(const Discretization& mesh, const CellData& weights, const char* what) {
    return weights.is_empty() ? Vector() : weights.on(mesh, what, Range::positive);
}

} // namespace

Shape shape_of(const Discretization& mesh, const BoundaryConditions& conditions,
               const CellData& conductivity, const CellData& density) {
    const Pieces& pieces = mesh.pieces();
    const int n = pieces.dimension();
    const bool are_by_cell =
        !conditions.facets.empty() || !conductivity.is_empty() || !density.is_empty();
    if (are_by_cell && mesh.complex().size(n) != pieces.size(n))
        throw InvalidInput("conditions by facet or weights on a mesh with merged cells: a shape "
                           "consists of the simplices, so discretize it with the criterion none");
    Shape shape{.pieces = pieces,
                .lengths = {},
                .conditions = conditions,
                .conductivity = weights_of(mesh, conductivity, "conductivity"),
                .density = weights_of(mesh, density, "density")};
    const SimplexMetric metric = mesh.geometry().metric();
    shape.lengths =
        metric.points() != nullptr ? edge_lengths(pieces, *metric.points()) : *metric.lengths();
    if (mesh.points().cols() > 0 || mesh.box()) // else the lengths are what is given
        shape.length_error = 4 * std::numeric_limits<double>::epsilon();
    if (!mesh.passage().is_identity())
        shape.length_error = error_of_flips(mesh.passage().flips());
    shape.lengths *= mesh.unit();
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
    if (std::find(fixed.begin(), fixed.end(), true) != fixed.end())
        throw InvalidInput("a vertex with a given value: functions on a shape are not bound at "
                           "points, so give conditions on facets");
    for (const double error : {shape.length_error, shape.metric_error})
        if (!(error >= 0 && error < 0.1))
            throw InvalidInput(fmt::format("lengths may be off by a share of {}: expected one from "
                                           "0 to 0.1",
                                           error));
    robin_coefficients(pieces, shape.conditions);
}

} // namespace polydec
