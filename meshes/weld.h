// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <optional>
#include <vector>

namespace polydec {

/// A mesh some of whose vertices have become one.
struct Joined {
    Mesh mesh;
    std::vector<Index> vertices; ///< of each given vertex its number in the mesh
    Index joined = 0;            ///< vertices that are gone
    Index apart = 0;             ///< those of them that were at a place of their own
};

/// How far apart vertices at one place may be: 1e-9 of the diagonal of the box around the points.
double weld_length(const Points& points);

/// Joins vertices that are at most `length` apart, and those between which others form a chain of
/// such steps: slits between cells close. Without a length, it is weld_length of the vertices that
/// cells use. The vertices of cells take the median of each coordinate, so that what most of them
/// have stays; numbers ascend by the first vertex joined. Cells keep rows, corners and tags.
///
/// No edge longer than the length vanishes, no cell is turned over that is thicker, and none comes
/// to lie on another of the opposite orientation that was elsewhere, as the sides of a thin plate
/// would: where that would happen, half the length is taken, and so on. Cells with shorter edges
/// keep their row with a corner twice; tidy leaves them out and tells.
///
/// Any dimension; results depend on neither units nor the order of vertices and cells. Time O(v log
/// v + cells). A warning of the mesh counts what was joined. Vertices of no cell stay.
/// Throws InvalidInput like check_mesh, and for a length that is negative or not finite.
Joined weld(Mesh mesh, std::optional<double> length = std::nullopt);

/// Welds, and splits cells of dimension 2 or 3 at the hanging nodes of their boundary, so that they
/// fit the smaller cells beside them: vertices inside boundary edges and, of tetrahedra, inside
/// boundary facets. Triangles are split as split_polygons does. Facets of tetrahedra that lie on
/// each other, in whole or in part, are divided into what they have in common, with new vertices
/// where edges of both cross, and the rest; a tetrahedron becomes a cone over its divided surface,
/// from a corner where that does, or else from a new vertex at its centroid.
///
/// Volume, orientation and tags stay: parts stand in the place of their cell. A warning counts
/// them. Throws InvalidInput like weld and tidy, naming the cell if it is too thin to be split, and
/// for hanging nodes of cells of another dimension.
Joined join_hanging(Mesh mesh, std::optional<double> length = std::nullopt);

} // namespace polydec
