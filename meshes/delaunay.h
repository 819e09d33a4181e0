// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <cstdint>

namespace polydec {

/// The Delaunay triangulation of points of the unit cube of R^n, 2 <= n <= 6, starting with the
/// cube's corners, in whatever order; other points of the boundary must have coordinates of exactly
/// 0 or 1. Bowyer and Watson's incremental insertion, near-linear for points that are spread
/// evenly. Ties are broken by random heights of the order of 1e-7 of the squared length `spacing`:
/// so cospherical points are triangulated, and cells are Delaunay up to such defects, far below the
/// tolerance of merging.
///
/// For meshes to test merging on, not for general use: throws InvalidInput, asking for another
/// seed, where rounding spoils the result (points that nearly coincide).
Mesh delaunay_in_cube(const Points& points, double spacing, std::uint64_t seed);

} // namespace polydec
