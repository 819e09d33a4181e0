// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/tetgen/tetgen_input.h"

#include <vector>

namespace polydec {

/// What TetGen made, in the unit of its input.
struct TetgenOutput {
    Points points = {};        ///< those of the input, in order, then new ones
    Simplices tetrahedra = {}; ///< four columns; determinants of the edge vectors are positive
    Simplices faces = {};      ///< the faces of tetrahedra that the surface consists of
    std::vector<Index> facets =
        {}; ///< for each of them a triangle of the input in whose patch it is
};

/// Holds it against the input. Every point stays where it was; every tetrahedron has a positive
/// volume, by an exact sign, and each face is in two of them, one on each side, or on the boundary.
/// The faces on the surface close as it does, lie in the planes of their patches and have their
/// areas; there are tetrahedra inside of each, up to the next one, unless a hole is there; the
/// boundary consists of such faces, and volumes add up to what the surface encloses.
/// Throws SolverFailure, saying what is not so.
void check_tetgen_output(const TetgenInput& input, const TetgenOutput& output);

} // namespace polydec
