// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <vector>

namespace polydec {

/// A surface of polygons in R^N.
struct PolygonMesh {
    Points points;                 ///< one row per vertex, N columns
    std::vector<Index> corners;    ///< vertex numbers around the faces, one face after the other
    std::vector<Index> offsets{0}; ///< face f has the corners offsets[f] to offsets[f + 1] - 1
    std::vector<Index> tags = {};  ///< of each face the number of its physical group, or empty
};

/// Splits polygons into triangles that keep orientation, vertex numbers and tags.
///
/// A polygon becomes a fan from its first corner, unless that makes a triangle without area (at
/// most 1e-6 of its longest edge squared) or one flipped against the polygon's area vector
/// (Newell's normal in R^3). Then the next corner is tried; where no fan fits, ears are cut off.
///
/// Faces with fewer than three corners are left out, and of equal corners that follow one another
/// in a polygon of more than three one is kept; triangles stay as they are. Warnings count all
/// this. Throws InvalidInput, naming the face, if offsets or corners are out of range, if a polygon
/// of more than 5000 corners has no fan, or if there is not one tag for each face.
Mesh split_polygons(PolygonMesh polygons);

/// Throws InvalidInput, naming face and vertex, unless offsets ascend from 0 to the number of
/// corners and every corner is a row of points.
void check_polygons(const PolygonMesh& polygons);

} // namespace polydec
