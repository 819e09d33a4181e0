// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/ranks.h"
#include "meshes/mesh.h"

#include <optional>
#include <string>

namespace polydec {

/// Vertex lists with numbers of the whole mesh.
using GlobalSimplices = Eigen::Matrix<GlobalIndex, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A rank's slice of a mesh in file order: equal ranges of its points and cells.
struct MeshSlice {
    GlobalIndex vertices = 0, cells = 0;    ///< of the whole mesh
    Points points;                          ///< of vertices EqualStretches(vertices, ranks)
    GlobalSimplices simplices;              ///< cells EqualStretches(cells, ranks)
    std::vector<std::string> warnings = {}; ///< of the mesh, on rank 0
    bool has_tags = false;                  ///< whether cells have groups, see Mesh
    std::vector<Index> tags = {};           ///< of the cells here; or empty: not read

    int ambient_dimension() const { return static_cast<int>(points.cols()); }
    int dimension() const { return static_cast<int>(simplices.cols()) - 1; }
};

/// This rank's slice of a mesh that every rank has.
MeshSlice slice_of(const Ranks& ranks, const Mesh& mesh);

/// Collective: the slices of a mesh from rank 0; arguments of other ranks are ignored. Throws
/// InvalidInput if rank 0 gives no mesh.
MeshSlice scatter(const Ranks& ranks, const std::optional<Mesh>& mesh);

/// Collective: the points of vertices, in ascending order of numbers, from the slices that contain
/// them.
Points points_of(const Ranks& ranks, const MeshSlice& slice,
                 const std::vector<GlobalIndex>& vertices);

/// How vertices, with the cells around them, are distributed over ranks. Results do not depend on
/// it; time and the number of duplicated cells do.
enum class Ownership {
    morton, ///< along a space-filling curve, in ranges of about equal length
    file,   ///< by their numbers, in equal ranges
    graph,  ///< by PTScotch, which cuts few edges: slower, with fewer duplicated cells
    random, ///< random: for tests
};

/// Collective: the rank that owns each vertex of the slice. Throws BackendUnavailable for `graph`
/// if PETSc was built without PTScotch, InvalidInput for vertex numbers out of range.
std::vector<int> vertex_owners(const Ranks& ranks, const MeshSlice& slice, Ownership by);

} // namespace polydec
