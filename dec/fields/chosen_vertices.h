// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"

#include <functional>
#include <string>
#include <vector>

namespace polydec {

/// 0-cells of a mesh, ascending, such as sources of distances. Those on its boundary; throws
/// InvalidInput if it has none.
std::vector<Index> boundary_vertices(const Discretization& mesh);

/// Those where the predicate holds, of points in the units of the input, size(0) rows. Throws
/// InvalidInput if it holds at none, and where only lengths are known.
std::vector<Index> vertices_where(const Discretization& mesh,
                                  const std::function<bool(const Vector& point)>& predicate);

/// Those of n-cells, or else of facets, in groups of the file, given by names or by tags in digits.
/// Throws InvalidInput for a group that there is not, or that has no such cells.
std::vector<Index> vertices_on(const Discretization& mesh, const std::vector<std::string>& groups);

} // namespace polydec
