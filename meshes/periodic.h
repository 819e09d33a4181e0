// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/length_mesh.h"

#include <functional>
#include <vector>

namespace polydec {

/// A mesh of a box (or of any cell that tiles space), glued to itself along translations or other
/// isometries: a torus, a Klein bottle or a twisted space that no R^n contains. It is given by its
/// edge lengths, with edges straight across the seams, and by the places of its simplices in the
/// box. It is discretized like any other mesh, and merges across the seams.
struct PeriodicMesh {
    Mesh box;                    ///< as given: contains each cell of the quotient once
    LengthMesh quotient;         ///< its simplices have the same rows as in the box
    std::vector<Index> vertices; ///< number in the quotient of each vertex of the box
    Points points;               ///< first place in the box of each vertex of the quotient

    int dimension() const { return box.dimension(); }
};

/// Glues vertices that differ by a translation, such as {1, 0} and {0, 1} for the unit square.
/// Throws InvalidInput, naming the translation or the cell, if a translation has a wrong number of
/// coordinates or maps no vertex to a vertex, or if the quotient is not a simplicial complex: every
/// translation needs three cells.
PeriodicMesh periodic(Mesh box, const std::vector<Vector>& translations);

/// An isometry as a map of points.
using Isometry = std::function<Vector(const Vector& point)>;

/// Glues vertices that isometries map to each other, such as (x + 1, 1 - y) with the translation
/// (x, y + 1): a Klein bottle from the unit square. A vertex may be a fixed point, such as the tip
/// of a wedge glued to a cone. Throws like periodic, with the number of the isometry from 0;
/// for an empty isometry; and naming an edge whose image has another length or is not an edge.
PeriodicMesh glue(Mesh box, const std::vector<Isometry>& isometries);

/// The same, given the images of the vertices under each isometry, one row per vertex.
PeriodicMesh glue_by_images(Mesh box, const std::vector<Points>& images);

} // namespace polydec
