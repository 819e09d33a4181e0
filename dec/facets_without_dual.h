// SPDX-License-Identifier: MIT
#pragma once

#include "complex/cell_complex.h"
#include "dec/forms/star.h"

#include <vector>

namespace polydec {

/// Marks the (n-1)-cells on the boundary whose dual, the half of an edge from the circumcenter of
/// the one n-cell beside them, has no length but for rounding (see HodgeStar::zeros): the center
/// lies on the boundary, as that of a right angle opposite to it. A dual 0-form has its boundary
/// value there. Size size(n-1); cells with another number of cofaces are not marked, and none is
/// where the star is a matrix.
std::vector<bool> boundary_facets_without_dual(const CellComplex& complex, const HodgeStars& stars);

} // namespace polydec
