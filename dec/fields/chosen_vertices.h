// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"

#include <functional>
#include <string>
#include <vector>

namespace polydec {

/// The 0-cells on the boundary of a mesh, ascending, e.g. as sources of distances. Throws
/// InvalidInput if the mesh has no boundary.
std::vector<Index> boundary_vertices(const Discretization& mesh);

/// The 0-cells at which the predicate holds; it is called with size(0) points in the units of the
/// input. Throws InvalidInput if it holds at none, and if only lengths are known.
std::vector<Index> vertices_where(const Discretization& mesh,
                                  const std::function<bool(const Vector& point)>& predicate);

/// Vertices of the n-cells, or else of the facets, in these groups of the file, by name or by tag
/// in digits. Throws InvalidInput for an unknown group and for one without such cells.
std::vector<Index> vertices_on(const Discretization& mesh, const std::vector<std::string>& groups);

} // namespace polydec
