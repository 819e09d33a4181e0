// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <cstdint>

namespace polydec::test {

/// Delaunay tetrahedra of the points of m^3 cubes of edge 1/m, each moved by at most jitter / m
/// along what of the boundary it lies on.
Mesh delaunay_grid(int m, double jitter, std::uint64_t seed = 1);

/// m^3 cubes of edge 1, each cut into five tetrahedra in one of the two ways: at random, with flat
/// ones on the squares that are cut differently on both sides, or so that they fit.
Mesh five_to_a_cube(int m, bool fitting = false);

/// Two prisms over hexagons, one on the other, cut from opposite corners: their common hexagon is a
/// fan around its corner 0 from above, around its corner 1 from below, with flat cells upon each
/// other between.
Mesh hexagonal_prisms();

} // namespace polydec::test
