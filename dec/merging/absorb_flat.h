// SPDX-License-Identifier: MIT
#pragma once

#include "complex/disjoint_sets.h"
#include "dec/metric/geometry.h"

#include <array>
#include <vector>

namespace polydec {

/// The n-simplices on both sides of each facet that may vanish; -1 at other facets.
using BothSides = std::vector<std::array<Index, 2>>;

/// Data on the corners and facets of flat n-simplices; entries elsewhere do not matter.
struct AroundFlat {
    BothSides sides;
    Vector sizes;    ///< of facets: twice the circumradius; length
    Vector shortest; ///< edge at each vertex; length
};

/// Joins flat n-simplices with the class of neighbors on whose sphere they lie, within the
/// tolerance times the shortest edge at their corners. A flat simplex on the face between two cells
/// lies on both spheres: it joins the smaller cell by volume, then by radius; among equal cells,
/// the cell whose sorted corners come first in space, as far as they are connected to it. So the
/// choice depends neither on numbers nor on rounding. Only pieces are compared, not cells. Classes
/// that flat simplices cut in two are joined first. `flat` has one mark per n-simplex. The result
/// for connected flat simplices depends only on these and the classes beside them. So it can be
/// computed on any part of a complex that contains all of them.
void absorb_flat(const Geometry& geometry, const std::vector<bool>& flat, const AroundFlat& around,
                 double tolerance, DisjointSets& classes);

} // namespace polydec
