// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <cstdint>

namespace polydec {

struct ClusterOptions {
    int dimension = 3;         ///< n = 2 .. 6
    int cells_per_side = 6;    ///< boxes along each axis; one random point in each
    int spheres = 1;           ///< empty spheres
    int points_on_sphere = 40; ///< random, evenly spread; n + 1 or more
    double radius = 0.25;      ///< of the spheres, below 1/2
    std::uint64_t seed = 1;    ///< gives the same mesh on every machine
};

/// Clusters of cospherical points in a random Delaunay mesh of the unit cube. The spheres do not
/// meet, have points on them and none inside; merging the simplices in each gives one Delaunay cell
/// with that many corners. Every box of a grid holds a random point, unless it is too near to a
/// sphere; the boundary has the points of the grid. Throws InvalidInput, naming the option and its
/// range, or if the spheres do not fit.
Mesh sphere_clusters(const ClusterOptions& options = {});

} // namespace polydec
