// SPDX-License-Identifier: MIT
#include "solvers/surfaces/surface_metric.h"

#include "backends/registry.h"
#include "complex/disjoint_sets.h"
#include "dec/metric/side_lengths.h"
#include "dec/metric/triangle.h"

#include <fmt/format.h>

#include <cmath>

namespace polydec {

namespace {

void find_components(SurfaceMetric& metric) {
    const Triangles& surface = metric.surface;
    DisjointSets sets(surface.vertices());
    std::vector<Index> vertex_of_edge(std::size_t(surface.edges()), 0);
    for (Index h = 0; h < 3 * surface.triangles(); ++h) {
        sets.join(surface.tail(h), surface.head(h));
        vertex_of_edge[surface.edge(h)] = surface.tail(h);
    }
    Index count = 0;
    for (Index v = 0; v < surface.vertices(); ++v) {
        const Index first = sets.find(v).element;
        metric.component.push_back(first == v ? count++ : metric.component[first]);
    }
    Vector edges = Vector::Zero(count);
    metric.mean_lengths = Vector::Zero(count);
    for (Index e = 0; e < surface.edges(); ++e) {
        const Index c = metric.component[vertex_of_edge[e]];
        metric.mean_lengths[c] += metric.lengths[e];
        edges[c] += 1;
    }
    metric.mean_lengths.array() /= edges.array();
}

} // namespace

SurfaceMetric surface_metric(const Triangles& surface, const Vector& lengths) {
    check_lengths(surface, lengths);
    if (surface.triangles() == 0)
        throw InvalidInput("the surface has no triangles: expected at least one");
    SurfaceMetric metric{surface};
    metric.unit = std::exp2(std::ilogb(lengths.maxCoeff()));
    metric.lengths = lengths / metric.unit;
    metric.areas.resize(surface.triangles());
    metric.cotangents.resize(3 * Eigen::Index(surface.triangles()));
    metric.vertex_areas = Vector::Zero(surface.vertices());
    for (Index t = 0; t < surface.triangles(); ++t) {
        const Index h = 3 * t;
        const auto [a, b, c] = side_lengths(surface, metric.lengths, t);
        const double area = triangle_area(a, b, c);
        metric.areas[t] = area;
        metric.cotangents[h] = corner_cotangent(a, b, c, area);
        metric.cotangents[h + 1] = corner_cotangent(b, c, a, area);
        metric.cotangents[h + 2] = corner_cotangent(c, a, b, area);
        for (Index i = 0; i < 3; ++i)
            metric.vertex_areas[surface.tail(h + i)] += metric.areas[t] / 3;
    }
    find_components(metric);
    return metric;
}

void check_time_scale(double time_scale) {
    if (!(time_scale >= 1e-6 && time_scale <= 1e6))
        throw InvalidInput(
            fmt::format("the time scale is {}: expected a number from 1e-6 to 1e6", time_scale));
}

std::string explained(const SurfaceMetric& metric, const std::string& failure) {
    Eigen::Index sharpest = 0;
    metric.cotangents.cwiseAbs().maxCoeff(&sharpest);
    const auto h = static_cast<Index>(sharpest);
    return fmt::format("{}\nProbably because of an angle of cotangent {:.1g} at vertex {} in "
                       "triangle {}: flip edges until the triangulation is Delaunay, which "
                       "changes neither distances nor transport.",
                       failure, metric.cotangents[sharpest],
                       metric.surface.vertex_number(metric.surface.tail(Triangles::previous(h))),
                       h / 3);
}

SparseMatrix surface_laplacian(const SurfaceMetric& metric, const Vector& factors) {
    const Triangles& surface = metric.surface;
    std::vector<Eigen::Triplet<double, Index>> entries;
    entries.reserve(12 * std::size_t(surface.triangles()));
    for (Index h = 0; h < 3 * surface.triangles(); ++h) {
        const Index i = surface.tail(h), j = surface.head(h);
        if (i == j)
            continue; // no difference along a loop
        const double weight = factors[metric.component[i]] * metric.cotangents[h] / 2;
        entries.emplace_back(i, i, weight), entries.emplace_back(j, j, weight);
        entries.emplace_back(i, j, -weight), entries.emplace_back(j, i, -weight);
    }
    SparseMatrix L(surface.vertices(), surface.vertices());
    L.setFromTriplets(entries.begin(), entries.end());
    return L;
}

} // namespace polydec
