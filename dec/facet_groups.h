// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/forms/boundary_conditions.h"

#include <string>
#include <vector>

namespace polydec {

/// Marks the facets of a mesh in one of these groups of the file, each given by its name or by its
/// tag in digits; a facet may be in several. size(n-1) marks. Throws InvalidInput, with the groups
/// there are, for one that there is not or that has no facet.
std::vector<bool> facets_in(const Discretization& mesh, const std::vector<std::string>& groups);

/// Mixed conditions: essential at the facets of the boundary in one of these groups, natural
/// elsewhere. Throws like facets_in, and for a group of which no facet is on the boundary.
BoundaryConditions essential_on(const Discretization& mesh, const std::vector<std::string>& groups);

} // namespace polydec
