// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <optional>
#include <vector>

namespace polydec {

/// A mesh without points: top simplices of one dimension n, and how long their edges are. The
/// lengths need not come from points of any space.
struct LengthMesh {
    Simplices simplices; ///< one row per n-simplex, n+1 columns; order gives orientation
    Index vertices = 0;  ///< vertex numbers are 0 .. vertices - 1
    Simplices edges;     ///< each edge of the simplices once: the numbers of its ends, in any order
    Vector lengths;      ///< one per row of edges

    int dimension() const { return static_cast<int>(simplices.cols()) - 1; }
};

/// The simplices of a mesh, with the lengths of their edges, sorted by vertex numbers. Throws like
/// distance().
LengthMesh length_mesh(const Mesh& mesh);

/// What is wrong with the edges of a length mesh, as a list of what its simplices have.
struct EdgeFault {
    enum class Kind { repeated, surplus, missing } kind;
    Index a, b;     ///< the edge's vertices, ascending
    Index row;      ///< where it stands, -1 if it is missing
    Index previous; ///< where a repeated edge stands before, else -1
};

/// The first fault in lexicographic order of edges, if there is one. Vertex numbers must be valid.
/// Time O(e log e), e the number of edges of all simplices.
std::optional<EdgeFault> edge_fault(const LengthMesh& mesh);

/// The rows of mesh.edges in lexicographic order of ascending vertex numbers.
std::vector<Index> edges_in_order(const LengthMesh& mesh);

/// Throws InvalidInput, naming the row or the edge, unless shapes fit, vertex numbers are in range,
/// and every edge of the simplices stands there exactly once, and no other. Lengths are not looked
/// at.
void check(const LengthMesh& mesh);

} // namespace polydec
