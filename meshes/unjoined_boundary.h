// SPDX-License-Identifier: MIT
#pragma once

#include "complex/simplicial_complex.h"
#include "meshes/mesh.h"

#include <vector>

namespace polydec {

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
