// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization/discretization.h"
#include "meshes/periodic.h"

#include <cstdint>
#include <vector>

namespace polydec {

/// The box from which a mesh was glued, with the places of its simplices. Every n-simplex of the
/// glued mesh is one of the box; a face on a seam corresponds to several simplices of the box.
class GluedBox {
public:
    /// `mesh` is discretize(glued.quotient), without flips. Linear time.
    GluedBox(const PeriodicMesh& glued, const Discretization& mesh);

    /// The box as a mesh of its own, in the unit of the glued mesh and with the same orientation of
    /// n-simplices. Its cells are the cells of the glued mesh, cut along the seams.
    const Discretization& mesh() const& { return parts_.mesh; }
    Discretization mesh() && { return mesh(); }

    /// The n-simplices of the glued mesh, between the points of the box.
    PlacedSimplices places() const& { return {mesh().measured_input_points(), parts_.corners}; }
    PlacedSimplices places() const&& = delete;

    /// The first place of each vertex of the glued mesh: one row per vertex.
    const Points& vertices() const& { return vertices_; }
    Points vertices() && { return vertices(); }

    /// For each k-simplex of the box, the k-simplex of the glued mesh that it becomes.
    struct Map {
        std::vector<Index> onto;
        std::vector<std::int8_t> signs; ///< 1 where both are oriented alike, else -1
        Index size = 0;                 ///< number of simplices of the glued mesh
    };
    const Map& map(int k) const&;
    Map map(int k) && { return map(k); }

private:
    struct Parts {
        Discretization mesh;
        std::vector<Map> maps; ///< by degree
        Simplices corners;     ///< see PlacedSimplices
    };
    static Parts parts(const PeriodicMesh& glued, const Discretization& mesh);

    Parts parts_;
    Points vertices_;
};

/// The mesh whose simplices lie between the points of their vertices: the box of a glued mesh, or
/// any other mesh itself. Returns a reference into the mesh.
const Discretization& placed(const Discretization& mesh);
const Discretization& placed(const Discretization&&) = delete;

/// The pull-back of primal k-cochains (columns) from the simplices of a mesh to those of
/// placed(mesh), which commutes with d; the way back for values equal on both sides of every seam,
/// which takes the value on the first simplex of the box; and the transpose of the pull-back, which
/// maps dual forms. If the mesh is not glued, they return the values unchanged.
DenseMatrix to_places(const Discretization& mesh, int k, const DenseMatrix& values);
DenseMatrix from_places(const Discretization& mesh, int k, const DenseMatrix& values);
DenseMatrix sums_from_places(const Discretization& mesh, int k, const DenseMatrix& values);

/// For each k-cell of placed(mesh), the k-cell of the mesh that contains it; -1 for cells inside
/// larger cells of the mesh that a seam has cut.
std::vector<Index> cells_of_places(const Discretization& mesh, int k);

} // namespace polydec
