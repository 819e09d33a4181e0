// SPDX-License-Identifier: MIT
#pragma once

#include "dec/boundary/boundary_conditions.h"
#include "dec/discretization/discretization.h"

#include <string>
#include <vector>

namespace polydec {

/// Marks the facets of a mesh that belong to at least one of these groups of the file. A group is
/// given by its name or by its tag in digits; a facet may be in several. size(n-1) marks. Throws
/// InvalidInput, listing the groups, for an unknown group and for one without facets.
std::vector<bool> facets_in(const Discretization& mesh, const std::vector<std::string>& groups);

/// Mixed conditions: essential on the boundary facets in these groups, natural elsewhere. Throws
/// like facets_in, and for a group with no facet on the boundary.
BoundaryConditions essential_on(const Discretization& mesh, const std::vector<std::string>& groups);

/// The 0-cells on the boundary of a mesh, ascending, e.g. as sources of distances. Throws
/// InvalidInput if the mesh has no boundary.
std::vector<Index> boundary_vertices(const Discretization& mesh);

/// Vertices of the n-cells, or else of the facets, in these groups of the file, by name or by tag
/// in digits. Throws InvalidInput for an unknown group and for one without such cells.
std::vector<Index> vertices_on(const Discretization& mesh, const std::vector<std::string>& groups);

} // namespace polydec
