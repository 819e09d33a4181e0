// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <span>
#include <vector>

namespace polydec {

/// A surface of polygons in R^N.
struct PolygonMesh {
    Points points;                 ///< one row per vertex, N columns
    std::vector<Index> corners;    ///< vertex numbers around the faces, one face after the other
    std::vector<Index> offsets{0}; ///< face f has the corners offsets[f] to offsets[f + 1] - 1
    std::vector<Index> tags = {};  ///< tag of the physical group of each face, or empty

    Index size() const { return static_cast<Index>(offsets.size()) - 1; } ///< number of faces

    /// The corners of face f.
    std::span<const Index> face(Index f) const {
        return {corners.data() + offsets[f], corners.data() + offsets[f + 1]};
    }

    /// Appends a face, without a tag.
    void add(std::span<const Index> face);

    /// Whether each face has this number of corners.
    bool all_have(Index number) const;
};

/// Splits polygons into triangles that keep orientation, vertex numbers and tags.
///
/// Polygons get Delaunay triangles: of two alternative diagonals, the one with the smaller sum of
/// opposite angles, even if the four corners are not coplanar. A tie goes to the shorter diagonal,
/// then to the one with the smallest vertex number. Unless there is no other way, no triangle has
/// less area than 1e-6 of its longest edge squared or is inverted relative to the polygon's area
/// vector (Newell's normal in R^3), and no diagonal is an edge of another face. If two polygons
/// want the same diagonal, it goes to the one that loses more without it. Equal polygons are split
/// equally. So the triangles depend neither on the first corner of a face nor on the order of
/// faces; the order of triangles does.
///
/// Faces with fewer than three corners are omitted. Repeated consecutive corners of a polygon with
/// more than three corners are merged; triangles stay unchanged. Warnings count both. A polygon of
/// more than 5000 corners becomes a fan from its smallest vertex. Throws InvalidInput, naming the
/// face, if that fan does not fit, if offsets or corners are out of range, or if there is not one
/// tag per face.
Mesh split_polygons(PolygonMesh polygons);

/// Throws InvalidInput, naming face and vertex, unless offsets ascend from 0 to the number of
/// corners, every corner is a row of points, and either every face has a tag or none has.
void check_polygons(const PolygonMesh& polygons);

} // namespace polydec
