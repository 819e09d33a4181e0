// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/tetgen/tetgen_input.h"

#include <vector>

namespace polydec {

/// TetGen's output, in the unit of its input.
struct TetgenOutput {
    Points points = {};             ///< the input points, in order, then new ones
    Simplices tetrahedra = {};      ///< four columns; determinants of the edge vectors are positive
    Simplices faces = {};           ///< the faces of tetrahedra that form the surface
    std::vector<Index> facets = {}; ///< for each face, a triangle of the input in its patch
};

/// Checks the output against the input. Every point stays where it was. Every tetrahedron has a
/// positive volume, by an exact sign. Each face is in two tetrahedra, one on each side, or on the
/// boundary. The surface faces close up like the surface, and lie in the planes of their patches
/// and have their areas. Each part contains tetrahedra, up to the next part, unless it has a hole.
/// The boundary consists of surface faces, and volumes add up to the enclosed volume. Throws
/// SolverFailure, naming the violated condition.
void check_tetgen_output(const TetgenInput& input, const TetgenOutput& output);

} // namespace polydec
