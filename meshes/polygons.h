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
/// The triangles of a polygon are its Delaunay triangles: of two diagonals that could replace each
/// other it has the one whose opposite angles have the smaller sum, also where four corners do not
/// lie in a plane. A tie goes to the shorter diagonal, and then to the one with the smallest vertex
/// number. No triangle has less area than 1e-6 of its longest edge squared or is flipped against
/// the polygon's area vector (Newell's normal in R^3), and no diagonal is an edge of another face,
/// unless there is no other way. If two polygons want the same diagonal, the one keeps it that
/// loses more without it. Equal polygons are split equally. So the triangles depend neither on the
/// corner that a face begins with nor on the order of the faces; the order of triangles does.
///
/// Faces with fewer than three corners are left out, and of equal corners that follow one another
/// in a polygon of more than three one is kept; triangles stay as they are. Warnings count all
/// this. A polygon of more than 5000 corners becomes a fan from its smallest vertex. Throws
/// InvalidInput, naming the face, if that fan does not fit, if offsets or corners are out of range,
/// or if there is not one tag for each face.
Mesh split_polygons(PolygonMesh polygons);

/// Throws InvalidInput, naming face and vertex, unless offsets ascend from 0 to the number of
/// corners, every corner is a row of points, and each face has a tag or none has.
void check_polygons(const PolygonMesh& polygons);

} // namespace polydec
