// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/length_mesh.h"

#include <functional>
#include <vector>

namespace polydec {

/// A mesh of a box (or of any cell that tiles space) glued to itself along translations or other
/// isometries: a torus, a Klein bottle or a space with a twist that no R^n holds, known by the
/// lengths of its edges, which go straight across the seams, and by where its simplices lie in the
/// box. It is discretized like any other mesh, and merges across the seams.
struct PeriodicMesh {
    Mesh box;                    ///< as it was given: where each cell of the quotient is once
    LengthMesh quotient;         ///< the rows of its simplices are those of the box
    std::vector<Index> vertices; ///< of each vertex of the box its number in the quotient
    Points points;               ///< of each vertex of the quotient its first place in the box

    int dimension() const { return box.dimension(); }
};

/// Glues vertices that differ by a translation, such as {1, 0} and {0, 1} for the unit square.
/// Throws InvalidInput, naming the translation or the cell, if a translation has another number of
/// coordinates or takes no vertex to one, or if the quotient is not a simplicial complex: along
/// every translation three cells are needed.
PeriodicMesh periodic(Mesh box, const std::vector<Vector>& translations);

/// Where an isometry takes a point.
using Isometry = std::function<Vector(const Vector& point)>;

/// Glues vertices that isometries take to each other, such as (x + 1, 1 - y) with the translation
/// (x, y + 1): a Klein bottle of the unit square. A vertex may stay where it is, as the tip of a
/// wedge does that is glued to a cone. Throws likewise, numbering the isometries from 0, and naming
/// an edge that is taken to one of another length, or to none.
PeriodicMesh glue(Mesh box, const std::vector<Isometry>& isometries);

/// The same by where each isometry takes the vertices, a row for each.
PeriodicMesh glue_by_images(Mesh box, const std::vector<Points>& images);

} // namespace polydec
