// SPDX-License-Identifier: MIT
#pragma once

#include "io/pictures/vtu.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace polydec {

/// The faces of VTK's tetrahedra and hexahedra, by their corners, oriented outward.
inline constexpr std::array<std::array<int, 3>, 4> tetra_faces{
    {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
inline constexpr std::array<std::array<int, 4>, 6> hexahedron_faces{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

/// Appends a solid, given by its outward faces, as a tetrahedron or hexahedron; returns false and
/// appends nothing if it is neither.
bool add_simple_solid(VtuGrid& grid, const std::vector<std::vector<Index>>& faces);

/// The faces of a polyhedron, by their corners, from the entries [begin, end) of a list like
/// VtuGrid::faces; none if these are not a number of faces and as many faces of 3 or more corners.
std::optional<std::vector<std::span<const Index>>>
polyhedron_faces(std::span<const Index> list, std::int64_t begin, std::int64_t end);

} // namespace polydec
