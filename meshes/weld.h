// SPDX-License-Identifier: MIT
#pragma once

#include "complex/simplicial_complex.h"
#include "meshes/mesh.h"

#include <optional>
#include <vector>

namespace polydec {

/// A mesh with some vertices joined.
struct Joined {
    Mesh mesh;
    std::vector<Index> vertices; ///< number in the mesh of each given vertex
    Index joined = 0;            ///< number of vertices removed
    Index apart = 0;             ///< of these, vertices with coordinates of their own
};

/// Distance within which vertices coincide: 1e-9 of the diagonal of the points' bounding box.
double weld_length(const Points& points);

/// Joins vertices at most `length` apart, and vertices connected by chains of such steps, which
/// closes slits between cells. The default is weld_length of the vertices that cells use. Joined
/// vertices take the median of each coordinate, so that the most frequent value survives; numbers
/// ascend by the first vertex joined. Cells keep rows, corners and tags.
///
/// No edge longer than `length` vanishes, and no cell thicker than `length` is inverted. No cell
/// comes to lie on a distinct one of opposite orientation, like the sides of a thin plate. Where
/// that would happen, the length is halved, repeatedly if needed. Cells with shorter edges keep
/// their row with a repeated corner; tidy omits them with a warning.
///
/// Any dimension; results do not depend on units or on the order of vertices and cells. Time O(v
/// log v + cells). A warning of the mesh counts joined vertices. Vertices of no cell stay. Throws
/// InvalidInput like check_mesh, and for a length that is negative or not finite.
Joined weld(Mesh mesh, std::optional<double> length = std::nullopt);

/// Welds, and splits cells of dimension 2 or 3 at the hanging nodes of their boundary, so that they
/// match the smaller cells beside them. Hanging nodes are vertices inside boundary edges and, for
/// tetrahedra, inside boundary facets. Triangles are split as in split_polygons. Overlapping facets
/// of tetrahedra are divided into the common part, with new vertices where edges cross, and the
/// rest. A tetrahedron becomes a cone over its divided surface, from a corner where possible, or
/// else from a new vertex at its centroid.
///
/// Volume, orientation and tags stay: parts replace their cell in its place. A warning counts them.
/// Throws InvalidInput like weld and tidy, naming the cell if it is too thin to be split, and for
/// hanging nodes of cells of another dimension.
Joined join_hanging(Mesh mesh, std::optional<double> length = std::nullopt);

/// Places where the boundary of a mesh touches itself unjoined: a slit for calculus, although the
/// cells leave no gap. Vertex numbers are the mesh's own, ascending.
struct UnjoinedBoundary {
    /// Boundary vertices within weld_length of another one: all but the first at each place.
    std::vector<Index> coincident;
    /// Boundary vertices, each place once, within weld_length of a boundary facet, but of none of
    /// its corners: hanging nodes inside edges (n >= 2) and inside facets (n >= 3). Facets with the
    /// corners of another facet count as joined: they have no hanging nodes.
    std::vector<Index> hanging;
    /// Boundary facets with their centroid within weld_length of another facet with other corners:
    /// facets on either side of hanging nodes, and other mismatches, such as a square with
    /// different diagonals on its two sides.
    Index misfits = 0;
};

/// Examines facets with one cell, in time O(boundary log(boundary)) after finding them. Any
/// dimension. Throws InvalidInput unless there is a point for each vertex of the complex.
UnjoinedBoundary unjoined_boundary(const SimplicialComplex& complex, const Points& points);

/// The same for a mesh as discretize takes it. Throws InvalidInput like tidy, keeping cells without
/// volume.
UnjoinedBoundary unjoined_boundary(const Mesh& mesh);

} // namespace polydec
