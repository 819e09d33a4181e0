// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <cstdint>
#include <vector>

namespace polydec {

/// Kuhn's (Freudenthal's) triangulation of a box in R^n, n = 1 .. 12: cells[k] equal boxes along
/// axis k, each split into n! simplices around its diagonal. All n-simplices have positive
/// determinant. Vertices are numbered lexicographically by their coordinates.
/// Without lengths the box is the unit cube.
/// Throws InvalidInput unless every count is >= 1, every length positive, sizes fit into 32 bits.
Mesh kuhn(const std::vector<int>& cells, const std::vector<double>& lengths = {});

/// The same for the unit cube of R^n, with equally many cells along every axis.
Mesh kuhn(int n, int cells_per_side);

/// The same boxes, each split at random into n! simplices. Every face of a box is a cone over its
/// facets that miss one of its corners; a random order of all vertices selects that corner, so
/// neighbors agree on shared faces. Merging gives the same grid of boxes as kuhn. The same seed
/// gives the same mesh on every machine. Throws like kuhn.
Mesh split_boxes(const std::vector<int>& cells, const std::vector<double>& lengths = {},
                 std::uint64_t seed = 1);

} // namespace polydec
