// SPDX-License-Identifier: MIT
#pragma once

#include "complex/disjoint_sets.h"
#include "complex/pieces.h"
#include "dec/metric/cell_volumes.h"

#include <array>
#include <vector>

namespace polydec {

/// The n-simplices on both sides of each facet with two that may vanish; -1 at others.
using Sides = std::vector<std::array<Index, 2>>;

/// Joins flat n-simplices with the class of neighbors on whose sphere they lie, within the
/// tolerance times the shortest edge at their corners. On the face between two cells they lie on
/// both spheres: they go to the cell whose sorted corners come first in space, as far as they hang
/// together with it; so the choice depends neither on numbers nor on rounding. Which it is decides
/// over pieces alone, not over cells. Classes that flat simplices cut in two are joined before.
/// `flat` has a mark for each n-simplex; `sizes` are twice the circumradii of facets.
void absorb_flat(const Pieces& complex, const Points& points, const CellVolumes& volumes,
                 const std::vector<bool>& flat, const Sides& sides, const Vector& sizes,
                 double tolerance, DisjointSets& classes);

} // namespace polydec
