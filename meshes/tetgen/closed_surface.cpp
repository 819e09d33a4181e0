// SPDX-License-Identifier: MIT
#include "meshes/tetgen/closed_surface.h"

#include "complex/disjoint_sets.h"
#include "complex/faces.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace polydec {

namespace {

using TrianglePlaces = std::array<Eigen::Vector3d, 3>;

/// The corners of a triangle, seen from an origin.
TrianglePlaces seen_from(const Eigen::Vector3d& origin, const Points& points,
                         const Simplices& triangles, Index f) {
    const auto corner = [&](int j) -> Eigen::Vector3d {
        return points.row(triangles(f, j)).transpose() - origin;
    };
    return {corner(0), corner(1), corner(2)};
}

/// Row 3f + j has the ends of edge j of triangle f.
SortedRows sorted_edges(const Simplices& triangles, Index points) {
    Simplices edges(3 * triangles.rows(), 2);
    for (Eigen::Index f = 0; f < triangles.rows(); ++f)
        for (int j = 0; j < 3; ++j)
            edges.row(3 * f + j) << triangles(f, j), triangles(f, (j + 1) % 3);
    return sorted_rows(edges, points);
}

/// Finds the neighbors, and joins them with the sign that says whether both turn alike.
void join_neighbors(const SortedRows& sorted, DisjointSets& parts, ClosedSurface& result) {
    const Simplices& edges = *sorted.simplices.rows;
    const auto& sides = sorted.order;
    const auto count = static_cast<Index>(edges.rows());
    for (Index begin = 0, end = 0; begin < count; begin = end) {
        Index first = sides[begin];
        for (end = begin; end < count && edges.row(end) == edges.row(begin); ++end)
            first = std::min(first, sides[end]);
        if (end - begin != 2) {
            result.odd_edges.push_back({edges(begin, 0), edges(begin, 1), end - begin, first / 3});
            continue;
        }
        const Index a = sides[begin], b = sides[begin + 1];
        result.across(a / 3, a % 3) = b / 3;
        result.across(b / 3, b % 3) = a / 3;
        const int sign = -sorted.signs[begin] * sorted.signs[begin + 1];
        if (!parts.join(a / 3, b / 3, sign) && result.twisted < 0)
            result.twisted = first / 3;
    }
}

/// The volumes of the pyramids over the triangles, from one corner of each part.
void measure(const Points& points, const Simplices& triangles, const std::vector<Index>& firsts,
             ClosedSurface& result) {
    for (std::size_t f = 0; f < result.part.size(); ++f) {
        const Eigen::Vector3d apex = points.row(triangles(firsts[f], 0));
        const auto [a, b, c] = seen_from(apex, points, triangles, static_cast<Index>(f));
        const Eigen::Vector3d area = (b - a).cross(c - a) / 2.0;
        result.volumes[result.part[f]] += result.sense[f] * area.dot(a) / 3.0;
        result.reach += area.norm() * std::max({a.norm(), b.norm(), c.norm()});
    }
}

} // namespace

ClosedSurface closed_surface(const Points& points, const Simplices& triangles) {
    ClosedSurface result;
    const auto count = static_cast<Index>(triangles.rows());
    result.across.resize(count, 3);
    DisjointSets parts(count);
    join_neighbors(sorted_edges(triangles, static_cast<Index>(points.rows())), parts, result);
    if (!result.odd_edges.empty() || result.twisted >= 0)
        return result;

    const auto firsts = parts.firsts();
    for (Index f = 0; f < count; ++f) {
        const Index first = firsts[f];
        if (first == f)
            result.volumes.push_back(0.0);
        result.part.push_back(first == f ? static_cast<Index>(result.volumes.size()) - 1
                                         : result.part[first]);
        result.sense.push_back(parts.find(f).sign);
    }
    measure(points, triangles, firsts, result);

    // what was taken for outward in a part may be inward
    for (std::size_t f = 0; f < result.sense.size(); ++f)
        if (result.volumes[result.part[f]] < 0.0)
            result.sense[f] = static_cast<std::int8_t>(-result.sense[f]);
    for (double& volume : result.volumes)
        volume = std::abs(volume);
    return result;
}

std::vector<double> windings(const Points& points, const Simplices& triangles,
                             const ClosedSurface& surface, const Eigen::Vector3d& place) {
    // The solid angle of a triangle: van Oosterom and Strackee, IEEE Trans. Biomed. Eng. 30 (1983).
    constexpr double in_plane = 1e-12;
    std::vector<double> turns(surface.volumes.size(), 0.0);
    for (std::size_t f = 0; f < surface.part.size(); ++f) {
        const auto [a, b, c] = seen_from(place, points, triangles, static_cast<Index>(f));
        const double lengths = a.norm() * b.norm() * c.norm();
        const double volume = a.dot(b.cross(c));
        if (std::abs(volume) <= in_plane * lengths)
            continue;
        const double cosine =
            lengths + a.dot(b) * c.norm() + b.dot(c) * a.norm() + c.dot(a) * b.norm();
        turns[surface.part[f]] +=
            surface.sense[f] * std::atan2(volume, cosine) / (2.0 * std::numbers::pi);
    }
    return turns;
}

} // namespace polydec
