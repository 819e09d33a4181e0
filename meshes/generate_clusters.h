// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <cstdint>

namespace polydec {

struct ClusterOptions {
    int dimension = 3;         ///< n = 2 .. 6
    int cells_per_side = 6;    ///< boxes along each axis; one random point in each
    int spheres = 1;           ///< empty ones
    int points_on_sphere = 40; ///< at random, spread evenly; n + 1 or more
    double radius = 0.25;      ///< of the spheres, below 1/2
    std::uint64_t seed = 1;    ///< the same mesh on every machine
};

/// Clusters of cospherical points in a random Delaunay mesh of the unit cube: spheres that do not
/// meet, with points on them and none inside, so that each is one Delaunay cell with that many
/// corners once the simplices in it are merged; a random point in every box of a grid, but for
/// those too near to a sphere; on the boundary the points of the grid. Throws InvalidInput, naming
/// the option and its range, or if there is no room for the spheres.
Mesh sphere_clusters(const ClusterOptions& options = {});

} // namespace polydec
