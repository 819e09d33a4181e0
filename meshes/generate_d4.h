// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <vector>

namespace polydec {

/// The lattice D4 in the unit cube of R^4: the points at multiples of 1 / (2 cells) with an even
/// sum of multiples. Its Delaunay cells are regular 16-cells, 24 to cells^4 cubes. One is around
/// the center of each small cube, and one around each omitted point, cut off at the boundary. Each
/// is split into 8 simplices around a diagonal; facets in the boundary have zero dual length. 192
/// simplices a cube, all of positive determinant.
/// Throws InvalidInput unless cells >= 1 and sizes fit into 32 bits.
Mesh d4(int cells);

/// The same in a box with cells[k] cubes of that edge along axis k; needs four counts.
/// Throws like bcc of a box.
Mesh d4(const std::vector<int>& cells, double edge = 1.0);

} // namespace polydec
