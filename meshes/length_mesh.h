// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <optional>
#include <vector>

namespace polydec {

/// A mesh without points: top simplices of one dimension n, and their edge lengths. The lengths
/// need not come from points in any space.
struct LengthMesh {
    Simplices simplices; ///< one row per n-simplex, n+1 columns; order gives orientation
    Index vertices = 0;  ///< vertex numbers are 0 .. vertices - 1
    Simplices edges;     ///< each edge of the simplices once: its two vertices, in any order
    Vector lengths;      ///< one per row of edges
    InputCells input_cells = {};
    int bisections = 0; ///< of the simplex that `refined` has divided most often

    int dimension() const { return static_cast<int>(simplices.cols()) - 1; }
};

/// The simplices of a mesh and their edge lengths, sorted by vertex numbers. Throws like
/// distance().
LengthMesh length_mesh(const Mesh& mesh);

/// A fault in the edge list of a length mesh, compared with the edges of its simplices.
struct EdgeFault {
    enum class Kind { repeated, surplus, missing } kind;
    Index a, b;     ///< the edge's vertices, ascending
    Index row;      ///< of the edge, -1 if it is missing
    Index previous; ///< of the first occurrence of a repeated edge, else -1
};

/// The first fault in lexicographic order of edges, if there is one. Vertex numbers must be valid.
/// Time O(e log e), e the number of edges of all simplices.
std::optional<EdgeFault> edge_fault(const LengthMesh& mesh);

/// The rows of mesh.edges in lexicographic order of ascending vertex numbers.
std::vector<Index> edges_in_order(const LengthMesh& mesh);

/// Throws InvalidInput, naming the row or the edge, unless shapes match, vertex numbers are in
/// range, and the list has every edge of the simplices exactly once and no other. Does not check
/// lengths.
void check(const LengthMesh& mesh);

} // namespace polydec
