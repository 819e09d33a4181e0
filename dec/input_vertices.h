// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"

#include <string_view>
#include <vector>

namespace polydec {

/// Vertices as the input numbers them, whether cells use them or not; behind them those that splits
/// have made. Forms, fields and points() have rows for the 0-cells alone, which are the vertices
/// that cells use.
Index count_vertices(const Discretization& mesh);

/// Of each 0-cell its vertex, ascending.
std::vector<Index> vertices_of_cells(const Discretization& mesh);

/// Of each of these vertices its 0-cell. Throws InvalidInput, saying what they are and naming the
/// vertex, for a number that there is not, and for a vertex that no cell uses.
std::vector<Index> cells_of_vertices(const Discretization& mesh, std::string_view what,
                                     const std::vector<Index>& vertices);

} // namespace polydec
