// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <vector>

namespace polydec {

/// Where a function has given values: (n-1)-simplices in the n-simplices of a mesh.
struct LevelSets {
    /// Of dimension n-1, oriented as the boundary of where the function is less. Points lie on
    /// edges and are shared by neighbors.
    Mesh mesh;
    std::vector<Index> owners; ///< of each simplex: that of the given mesh which it lies in
    std::vector<Index> levels; ///< of each simplex: the number of its level
};

/// The level sets of the function that has these values at the vertices and is linear on every
/// simplex, in any dimension n >= 1: isolines for n = 2, isosurfaces for n = 3. Each is the
/// boundary of where the function is less than the level: closed but where the mesh has a boundary,
/// with no simplex of zero volume at vertices that have the level itself. Time O(simplices log
/// levels + m log m) for m simplices of the result. Source: the level set in a simplex is a product
/// of two simplices, cut by lattice paths. Throws InvalidInput, naming it, for a value or level
/// that is not finite, as many values as there are not vertices, levels that do not ascend, a
/// vertex that is not there, or n < 1.
LevelSets level_sets(const Mesh& mesh, const Vector& values, const Vector& levels);

/// As many levels at equal distances between the least and the largest value, without these; count
/// >= 0. Throws InvalidInput for no values, or one that is not finite.
Vector equal_levels(const Vector& values, Index count);

} // namespace polydec
