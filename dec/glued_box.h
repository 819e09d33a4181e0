// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "meshes/periodic.h"

#include <cstdint>
#include <vector>

namespace polydec {

/// The box that a mesh was glued from, which says where its simplices lie. Every n-simplex of the
/// glued mesh is one of the box; its faces on a seam are several simplices of the box.
class GluedBox {
public:
    /// `mesh` is discretize(glued.quotient), without flips. Linear time.
    GluedBox(const PeriodicMesh& glued, const Discretization& mesh);

    /// The box as a mesh of its own, in the unit of the glued one and with the orientation of its
    /// n-simplices. Its cells are the cells of that mesh, cut along the seams.
    const Discretization& mesh() const { return mesh_; }

    /// The n-simplices of the glued mesh, between the points of the box.
    PlacedSimplices places() const { return {mesh_.measured_input_points(), corners_}; }

    /// The first place of each vertex of the glued mesh: a row for each.
    const Points& vertices() const { return vertices_; }

    /// The k-simplex of the glued mesh that each one of the box becomes.
    const std::vector<Index>& onto(int k) const;

    /// Primal k-cochains, a column each, from the simplices of the glued mesh to those of the box:
    /// the pull-back, which commutes with d.
    DenseMatrix back(int k, const DenseMatrix& values) const;

    /// The other way, for cochains that have the same values on both sides of every seam: the value
    /// of the first simplex of the box.
    DenseMatrix forth(int k, const DenseMatrix& values) const;

    /// The sums over the simplices of the box that become one: the transpose of the pull-back, and
    /// so the way of dual forms.
    DenseMatrix sums(int k, const DenseMatrix& values) const;

private:
    struct Map {
        std::vector<Index> onto;        ///< of each simplex of the box
        std::vector<std::int8_t> signs; ///< 1 where both are oriented alike, else -1
        Index size = 0;                 ///< number of simplices of the glued mesh
    };
    struct Found;
    explicit GluedBox(Found found);
    static Found found(const PeriodicMesh& glued, const Discretization& mesh);

    Discretization mesh_;
    std::vector<Map> maps_; // by degree
    Simplices corners_;
    Points vertices_;
};

/// The mesh whose simplices lie between points of their vertices: the box of a glued mesh, any
/// other mesh itself. Refers into the mesh.
const Discretization& placed(const Discretization& mesh);
const Discretization& placed(const Discretization&&) = delete;

/// GluedBox::back, forth and sums, between the simplices of a mesh and of placed(mesh); values of
/// other meshes stay as they are.
DenseMatrix to_places(const Discretization& mesh, int k, const DenseMatrix& values);
DenseMatrix from_places(const Discretization& mesh, int k, const DenseMatrix& values);
DenseMatrix sums_from_places(const Discretization& mesh, int k, const DenseMatrix& values);

/// Of each k-cell of placed(mesh) the k-cell of the mesh that it is a part of; -1 for those inside
/// of larger cells of the mesh, which a seam has cut.
std::vector<Index> cells_of_places(const Discretization& mesh, int k);

} // namespace polydec
