// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <cstdint>
#include <vector>

namespace polydec {

/// The mesh with every coordinate moved at random, independently and uniformly, by at most
/// `amplitude`. The same seed gives the same mesh on every machine.
/// Throws InvalidInput unless the amplitude is finite and not negative.
Mesh perturbed(Mesh mesh, double amplitude, std::uint64_t seed);

/// A mesh whose vertices and cells have been renumbered.
struct Shuffled {
    Mesh mesh;
    std::vector<Index> vertices; ///< vertices[i]: old number of vertex i
    std::vector<Index> cells;    ///< cells[i]: old number of cell i
};

/// The same mesh under random vertex and cell numbers; cells keep the order of their corners, so
/// their orientation, and their tags. The same seed gives the same numbers on every machine.
/// Throws InvalidInput, naming the cell, if a vertex number is out of range, or if there are tags,
/// but not one for each cell.
Shuffled shuffled(const Mesh& mesh, std::uint64_t seed);

} // namespace polydec
