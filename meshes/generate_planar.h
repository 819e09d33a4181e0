// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

namespace polydec {

/// The rectangle [0, width] x [0, height] in nx times ny equal rectangles, each split by the
/// diagonal from its lower left to its upper right corner. All triangles are counterclockwise.
/// Vertex (i, j) at (i width / nx, j height / ny) has the number i (ny + 1) + j.
/// Throws InvalidInput unless nx, ny >= 1, lengths are positive, sizes fit into 32 bits.
Mesh grid(int nx, int ny, double width = 1.0, double height = 1.0);

/// The unit square in rows of hexagons, `columns` >= 2 to a row, cut at the boundary and fanned
/// into counterclockwise triangles. The number of rows is the odd one that makes the hexagons
/// nearly regular. The row heights put the corners of every polygon on a circle, including the half
/// hexagons and pentagons at the boundary. Half hexagons at the left and right boundary have their
/// circumcenters on it, so their boundary edges have zero dual length. Throws InvalidInput unless
/// columns >= 2 and sizes fit into 32 bits.
Mesh hexagons(int columns);

/// The unit square in 2 `rows` rows of acute triangles, all counterclockwise: every circumcenter
/// lies strictly inside its triangle, so there is nothing to merge and all duals are positive.
/// Throws InvalidInput unless rows >= 2 and sizes fit into 32 bits.
Mesh well_centered(int rows);

} // namespace polydec
