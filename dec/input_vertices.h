// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"

#include <string_view>
#include <vector>

namespace polydec {

/// Number of vertices: all vertices of the input, used by cells or not, followed by the vertices
/// that splits have added. Forms, fields and points() have rows for the 0-cells only, that is, for
/// the vertices that cells use.
Index count_vertices(const Discretization& mesh);

/// For each 0-cell its vertex, ascending.
std::vector<Index> vertices_of_cells(const Discretization& mesh);

/// For each of these vertices its 0-cell. Throws InvalidInput, naming `what` and the vertex, for a
/// number out of range, and for a vertex that no cell uses.
std::vector<Index> cells_of_vertices(const Discretization& mesh, std::string_view what,
                                     const std::vector<Index>& vertices);

} // namespace polydec
