// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/ranks.h"
#include "meshes/mesh.h"

#include <optional>
#include <string>

namespace polydec {

/// Vertex lists with numbers of the whole mesh.
using GlobalSimplices = Eigen::Matrix<GlobalIndex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// What one rank has of a mesh as it stands in a file: equal stretches of its points and cells.
struct MeshSlice {
    GlobalIndex vertices = 0, cells = 0;    ///< of the whole mesh
    Points points;                          ///< of the vertices EqualStretches(vertices, ranks)
    GlobalSimplices simplices;              ///< the cells EqualStretches(cells, ranks)
    std::vector<std::string> warnings = {}; ///< of the mesh, on rank 0

    int ambient_dimension() const { return static_cast<int>(points.cols()); }
    int dimension() const { return static_cast<int>(simplices.cols()) - 1; }
};

/// The slice of this rank, of a mesh that every rank has.
MeshSlice slice_of(const Ranks& ranks, const Mesh& mesh);

/// Collective: the slices of a mesh that rank 0 has; what others give is not looked at. Throws
/// InvalidInput if rank 0 has none.
MeshSlice scatter(const Ranks& ranks, const std::optional<Mesh>& mesh);

/// Collective: the points of vertices, in ascending order of their numbers, from the slices that
/// have them.
Points points_of(const Ranks& ranks, const MeshSlice& slice,
                 const std::vector<GlobalIndex>& vertices);

/// By what vertices are given to ranks, and with them the cells around them. What is computed does
/// not depend on it, but the time does, and how much is held twice.
enum class Ownership {
    morton, ///< along a curve through space, in stretches of about equal length
    file,   ///< by their numbers, in equal stretches
    graph,  ///< by PTScotch, which cuts few edges: takes longer, and holds fewer cells twice
    random, ///< in no order at all: for tests
};

/// Collective: the rank that owns each vertex of the slice. Throws BackendUnavailable for a graph
/// if PETSc was built without PTScotch, InvalidInput for vertex numbers that there are not.
std::vector<int> vertex_owners(const Ranks& ranks, const MeshSlice& slice, Ownership by);

} // namespace polydec
