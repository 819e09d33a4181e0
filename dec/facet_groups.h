// SPDX-License-Identifier: MIT
#pragma once

#include "dec/boundary/boundary_conditions.h"
#include "dec/discretization.h"

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

} // namespace polydec
