// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"

#include <vector>

namespace polydec {

/// Marks the (n-1)-cells on the boundary whose dual, the half of an edge from the circumcenter of
/// the one n-cell beside them, counts as nothing within the tolerance of the merging: the center
/// lies on the boundary, as that of a right angle opposite to it. A dual 0-form has its boundary
/// value there. Size size(n-1) of complex(); cells with another number of cofaces are not marked.
/// With other stars than circumcentric ones: those whose entry is zero.
std::vector<bool> boundary_facets_without_dual(const Discretization& discretization);

/// The same of any cells, of whose facets no sizes are known: those whose star entry is zero (see
/// HodgeStar::zeros); a star that is a matrix leaves none without.
std::vector<bool> boundary_facets_without_dual(const CellComplex& complex, const HodgeStars& stars);

} // namespace polydec
