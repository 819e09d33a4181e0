// SPDX-License-Identifier: MIT
#pragma once

#include "complex/simplicial_complex.h"
#include "meshes/mesh.h"

#include <vector>

namespace polydec {

/// Where the boundary of a mesh lies upon itself without being joined: the mesh is slit there, for
/// calculus, although its cells leave no gap. Vertex numbers are the mesh's own, ascending.
struct UnjoinedBoundary {
    /// Boundary vertices within weld_length of another one: of each place all but the first.
    std::vector<Index> coincident;
    /// Boundary vertices, each place once, within weld_length of a facet of the boundary, but of
    /// none of its corners: hanging nodes inside edges (n >= 2) and inside facets (n >= 3). Facets
    /// whose corners coincide with those of another facet count as joined: they lack no vertices.
    std::vector<Index> hanging;
    /// Facets of the boundary with their centroid within weld_length of another, but other corners:
    /// those on either side of hanging nodes, and others that do not fit, such as the triangles of
    /// a square that both of its sides divide by different diagonals.
    Index misfits = 0;
};

/// Looks at facets with one cell: time O(boundary log(boundary)) beside that of finding them. Any
/// dimension. Throws InvalidInput unless there is a point for each vertex of the complex.
UnjoinedBoundary unjoined_boundary(const SimplicialComplex& complex, const Points& points);

/// The same of a mesh as discretize would take it. Throws InvalidInput like tidy, which keeps cells
/// without volume.
UnjoinedBoundary unjoined_boundary(const Mesh& mesh);

} // namespace polydec
