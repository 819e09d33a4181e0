// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <vector>

namespace polydec {

/// Body-centered cubic lattice in the unit cube: corners and centers of cells^3 cubes. Four
/// congruent tetrahedra surround each inner square. Behind each boundary square is half of that, an
/// exactly cospherical pyramid split by the square's diagonal. 12 tetrahedra a cube, all of
/// positive determinant. Throws InvalidInput unless cells >= 1 and sizes fit into 32 bits.
Mesh bcc(int cells);

/// The same in a box with cells[k] cubes of that edge along axis k. Unlike Kuhn's simplices,
/// lattice simplices need cubes. Also throws InvalidInput unless there are three counts and the
/// edge is positive.
Mesh bcc(const std::vector<int>& cells, double edge = 1.0);

/// Face-centered cubic lattice in the unit cube: corners and face centers of cells^3 cubes. Its
/// cells are regular tetrahedra and octahedra; the octahedra are split into four around a diagonal:
/// around x in the middle of a cube, around the cube's edge otherwise. 24 tetrahedra a cube, all of
/// positive determinant; facets in the boundary have zero dual length. Throws InvalidInput unless
/// cells >= 1 and sizes fit into 32 bits.
Mesh fcc(int cells);

/// The same in a box with cells[k] cubes of that edge along axis k. Throws like bcc of a box.
Mesh fcc(const std::vector<int>& cells, double edge = 1.0);

} // namespace polydec
