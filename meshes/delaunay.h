// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <cstdint>

namespace polydec {

/// The Delaunay triangulation of points in the unit cube of R^n, 2 <= n <= 6. The points begin with
/// the cube's corners, in any order; other boundary points need coordinates of exactly 0 or 1. Uses
/// the Bowyer-Watson incremental insertion, near-linear for evenly spread points. Random heights of
/// the order of 1e-7 of the squared length `spacing` break ties. Cospherical points are thus
/// triangulated, and cells are Delaunay up to such defects, far below the tolerance of merging.
///
/// Makes test meshes for merging; not for general use. Throws InvalidInput, suggesting another
/// seed, if rounding spoils the result (points that nearly coincide).
Mesh delaunay_in_cube(const Points& points, double spacing, std::uint64_t seed);

} // namespace polydec
