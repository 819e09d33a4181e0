// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <vector>

namespace polydec {

/// Kuhn's (Freudenthal's) triangulation of a box in R^n, n = 1 .. 12: cells[k] equal boxes along
/// axis k, each split into n! simplices around its diagonal. All n-simplices have positive
/// determinant. Vertices are numbered lexicographically by their coordinates.
/// Without lengths the box is the unit cube.
/// Throws InvalidInput unless every count is >= 1, every length positive, sizes fit into 32 bits.
Mesh kuhn(const std::vector<int>& cells, const std::vector<double>& lengths = {});

/// The same of the unit cube of R^n with equally many cells along every axis.
Mesh kuhn(int n, int cells_per_side);

/// Body-centered cubic lattice in the unit cube: corners and centers of cells^3 cubes. Around each
/// inner square four congruent tetrahedra; behind each square of the boundary half of that, an
/// exactly cospherical pyramid split by the square's diagonal. 12 cells^3 tetrahedra, all of
/// positive determinant. Throws InvalidInput unless cells >= 1 and sizes fit into 32 bits.
Mesh bcc(int cells);

/// Face-centered cubic lattice in the unit cube: corners and face centers of cells^3 cubes. Regular
/// tetrahedra and octahedra, these split into four around a diagonal: around x in the middle of a
/// cube, around the cube's edge otherwise. 24 cells^3 tetrahedra, all of positive determinant;
/// facets in the boundary have zero dual length.
/// Throws InvalidInput unless cells >= 1 and sizes fit into 32 bits.
Mesh fcc(int cells);

} // namespace polydec
