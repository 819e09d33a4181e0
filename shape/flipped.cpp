// SPDX-License-Identifier: MIT
#include "complex/surfaces/ordered_surface.h"
#include "dec/surfaces/intrinsic_delaunay.h"
#include "shape/measured_simplex.h"
#include "shape/shape.h"

#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace polydec {

namespace {

bool is_constant(const Vector& weights) {
    return weights.size() == 0 || weights.minCoeff() == weights.maxCoeff();
}

} // namespace

FlippedShape flipped(const Shape& shape) {
    check(shape);
    const Pieces& pieces = shape.pieces;
    if (pieces.dimension() != Triangles::dimension || !GluedSurface::accepts(pieces) ||
        !is_constant(shape.conductivity) || !is_constant(shape.density))
        return {shape};
    const auto flips = intrinsic_delaunay(GluedSurface(pieces), shape.lengths);
    if (flips.statistics.flips == 0 && flips.statistics.added_length == 0)
        return {shape};
    std::vector<Index> vertices(pieces.size(0));
    std::iota(vertices.begin(), vertices.end(), Index{0});
    Shape result = shape;
    result.pieces = in_order(flips.surface, pieces.vertex_numbers(vertices)).pieces;
    result.lengths = flips.lengths;
    // every flip rounds the length of an edge, which others follow from
    const double error = 64 * std::numeric_limits<double>::epsilon() +
                         2 * flips.statistics.added_length / flips.lengths.minCoeff();
    result.length_error = 0;
    result.metric_error = metric_share(shape) + error * most_sensitivity(result);
    return {std::move(result), flips.statistics.flips};
}

} // namespace polydec
