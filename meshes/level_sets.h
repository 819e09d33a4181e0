// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <vector>

namespace polydec {

/// Level sets of a function: (n-1)-simplices in the n-simplices of a mesh.
struct LevelSets {
    /// Of dimension n-1, oriented as the boundary of the sublevel set. Points lie on edges and are
    /// shared by neighbors.
    Mesh mesh;
    std::vector<Index> owners; ///< for each simplex, the simplex of the given mesh that contains it
    std::vector<Index> levels; ///< for each simplex, the number of its level
};

/// The level sets of the function with these vertex values, linear on every simplex, in any
/// dimension n >= 1: isolines for n = 2, isosurfaces for n = 3. Each is the boundary of the
/// sublevel set: closed except at the boundary of the mesh, without zero-volume simplices at
/// vertices on the level, up to 1e-12 of the range of values. Time O(simplices log levels + m log
/// m) for m simplices of the result. Source: the level set in a simplex is a product of two
/// simplices, cut by lattice paths. Throws InvalidInput for a value or level that is not finite,
/// naming it, a wrong number of values, levels that do not ascend, a vertex out of range, or n < 1.
LevelSets level_sets(const Mesh& mesh, const Vector& values, const Vector& levels);

/// `count` >= 0 equally spaced levels strictly between the smallest and the largest value. Throws
/// InvalidInput for no values, one that is not finite, or levels between values
/// that are all equal up to rounding.
Vector equal_levels(const Vector& values, Index count);

} // namespace polydec
