// SPDX-License-Identifier: MIT
#include "dec/surfaces/glued_volumes.h"

#include "base/errors.h"
#include "dec/merging/merged_volumes.h"
#include "dec/metric/rounding.h"
#include "dec/metric/triangle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace polydec {

void check_lengths(const GluedSurface& surface, const Vector& lengths) {
    if (lengths.size() != surface.edges())
        throw InvalidInput(fmt::format("{} lengths are given for {} edges: expected one for each",
                                       lengths.size(), surface.edges()));
    for (Index e = 0; e < surface.edges(); ++e)
        if (!(lengths[e] > 0 && std::isfinite(lengths[e])))
            throw InvalidInput(fmt::format("edge {} from vertex {} to {} has length {}: expected a "
                                           "positive number",
                                           e, surface.first_vertex(e), surface.last_vertex(e),
                                           lengths[e]));
    for (Index t = 0; t < surface.triangles(); ++t) {
        const auto [a, b, c] = side_lengths(surface, lengths, t);
        const double longest = std::max({a, b, c});
        if (!(triangle_area(a / longest, b / longest, c / longest) > 0))
            throw InvalidInput(fmt::format(
                "triangle {} with vertices {}, {}, {} has sides of lengths {}, {} and {}: no "
                "triangle with an area has them",
                t, surface.tail(3 * t), surface.tail(3 * t + 1), surface.tail(3 * t + 2), a, b, c));
    }
}

std::array<double, 3> side_lengths(const GluedSurface& surface, const Vector& lengths,
                                   Index triangle) {
    return {lengths[surface.edge(3 * triangle)], lengths[surface.edge(3 * triangle + 1)],
            lengths[surface.edge(3 * triangle + 2)]};
}

namespace {

/// Squares of areas, which are products of four lengths, must be ordinary numbers.
void check_scale(const GluedSurface& surface, const Vector& lengths) {
    constexpr double largest = 1e70;
    for (Index e = 0; e < surface.edges(); ++e)
        if (lengths[e] > largest || lengths[e] < 1 / largest)
            throw InvalidInput(fmt::format("edge {} from vertex {} to {} has length {:.3g}: "
                                           "measure the surface in units nearer to it, or leave "
                                           "out what is so much smaller than the rest",
                                           e, surface.first_vertex(e), surface.last_vertex(e),
                                           lengths[e]));
}

} // namespace

CellVolumes circumcentric_volumes(const GluedSurface& surface, const Vector& lengths) {
    check_lengths(surface, lengths);
    check_scale(surface, lengths);
    Vector areas(surface.triangles()), area_terms(surface.triangles());
    Vector dual_edges = Vector::Zero(surface.edges()), edge_terms = dual_edges;
    Vector dual_vertices = Vector::Zero(surface.vertices()), vertex_terms = dual_vertices;
    for (Index t = 0; t < surface.triangles(); ++t) {
        const auto side = side_lengths(surface, lengths, t);
        areas[t] = triangle_area(side[0], side[1], side[2]);
        area_terms[t] = triangle_area_terms(side[0], side[1], side[2], areas[t]);
        for (Index i = 0; i < 3; ++i) {
            const double a = side[i], b = side[(i + 1) % 3], c = side[(i + 2) % 3];
            const double height = a * corner_cotangent(a, b, c, areas[t]) / 2;
            dual_edges[surface.edge(3 * t + i)] += height;
            edge_terms[surface.edge(3 * t + i)] +=
                std::abs(height) + triangle_height_terms(a, b, c, areas[t]);
        }
    }
    for (Index e = 0; e < surface.edges(); ++e)
        for (const Index v : {surface.first_vertex(e), surface.last_vertex(e)}) {
            dual_vertices[v] += lengths[e] * dual_edges[e] / 4;
            vertex_terms[v] += lengths[e] * edge_terms[e] / 4;
        }
    const Vector ones = Vector::Ones(surface.triangles());
    const auto rounding = [](const Vector& terms) { return Vector(terms.unaryExpr(&rounding_of)); };
    return {{Vector::Ones(surface.vertices()), lengths, std::move(areas)},
            {std::move(dual_vertices), std::move(dual_edges), ones},
            {vertex_terms, edge_terms, ones},
            {rounding(vertex_terms), rounding(edge_terms), rounding(area_terms)}};
}

CellVolumes merged_volumes(const MergedSurface& merging, const CellVolumes& triangles) {
    return merged_volumes(merging.diamonds, triangles);
}

} // namespace polydec
