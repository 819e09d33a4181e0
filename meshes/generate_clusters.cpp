// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "base/random.h"
#include "meshes/delaunay.h"
#include "meshes/generate.h"
#include "meshes/generate_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace polydec {

namespace {

void check(const ClusterOptions& options) {
    const char* name = "sphere_clusters";
    check_count(name, "dimension", options.dimension, 2, 6);
    check_count(name, "cells_per_side", options.cells_per_side, 1);
    check_count(name, "spheres", options.spheres, 0);
    check_count(name, "points_on_sphere", options.points_on_sphere, options.dimension + 1, 10000);
    check_length(name, "radius", options.radius);
    const double vertices = std::pow(options.cells_per_side + 1.0, options.dimension);
    // mean numbers of simplices for each of many random points
    constexpr std::array simplices{0.0, 1.0, 2.0, 6.8, 31.8, 187.0, 1300.0};
    check_sizes(name, 2.0 * vertices, simplices[options.dimension] * vertices, options.dimension);
}

/// Centers of spheres that keep a distance from each other and from the cube's boundary.
std::vector<Vector> centers(const ClusterOptions& options, double distance, Random& random) {
    const int n = options.dimension;
    const double room = 1.0 - 2.0 * (options.radius + distance);
    std::vector<Vector> result;
    for (int attempt = 0; attempt < 1000 * options.spheres && room >= 0.0; ++attempt) {
        if (static_cast<int>(result.size()) == options.spheres)
            break;
        const Vector center = (room * random.point(n)).array() + (1.0 - room) / 2.0;
        bool is_free = true;
        for (const Vector& other : result)
            is_free = is_free && (other - center).norm() > 2.0 * options.radius + distance;
        if (is_free)
            result.push_back(center);
    }
    if (static_cast<int>(result.size()) < options.spheres)
        throw InvalidInput(fmt::format("sphere_clusters: only {} spheres of radius {} fit at least "
                                       "{} apart; choose fewer or smaller spheres, or more cells",
                                       result.size(), options.radius, distance));
    return result;
}

/// Directions, each the farthest of some random ones from those before it.
std::vector<Vector> spread_directions(int n, int count, Random& random) {
    std::vector<Vector> result;
    while (static_cast<int>(result.size()) < count) {
        Vector best;
        double farthest = -1.0;
        for (int candidate = 0; candidate < 10; ++candidate) {
            const Vector direction = random.direction(n);
            double nearest = 2.0;
            for (const Vector& other : result)
                nearest = std::min(nearest, (other - direction).norm());
            if (nearest > farthest) {
                farthest = nearest;
                best = direction;
            }
        }
        result.push_back(best);
    }
    return result;
}

bool is_far(const Vector& p, const std::vector<Vector>& centers, double distance) {
    for (const Vector& center : centers)
        if ((p - center).norm() < distance)
            return false;
    return true;
}

} // namespace

Mesh sphere_clusters(const ClusterOptions& options) {
    check(options);
    const int n = options.dimension, cells = options.cells_per_side;
    const double spacing = 1.0 / cells;
    Random random(options.seed);
    const std::vector<Vector> middles = centers(options, 0.5 * spacing, random);

    // first the corners of the cube, where the triangulation starts
    std::vector<Vector> points;
    const Points corners = kuhn(n, 1).points, grid = kuhn(n, cells).points;
    for (const auto& p : corners.rowwise())
        points.emplace_back(p.transpose());
    for (const Vector& middle : middles)
        for (const Vector& direction : spread_directions(n, options.points_on_sphere, random))
            points.emplace_back(middle + options.radius * direction);
    for (const auto& p : grid.rowwise()) {
        const auto ends = ((p.array() == 0.0) || (p.array() == 1.0)).count();
        if (ends > 0 && ends < n)
            points.emplace_back(p.transpose());
        if (p.maxCoeff() == 1.0)
            continue;
        const Vector inside =
            p.transpose() + spacing * (0.2 + 0.6 * random.point(n).array()).matrix();
        if (is_far(inside, middles, options.radius + 0.25 * spacing))
            points.push_back(inside);
    }

    Points rows(static_cast<Eigen::Index>(points.size()), n);
    for (Eigen::Index v = 0; v < rows.rows(); ++v)
        rows.row(v) = points[v];
    return delaunay_in_cube(rows, spacing, options.seed);
}

} // namespace polydec
