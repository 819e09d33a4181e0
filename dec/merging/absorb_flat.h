// SPDX-License-Identifier: MIT
#pragma once

#include "complex/disjoint_sets.h"
#include "dec/metric/geometry.h"

#include <array>
#include <vector>

namespace polydec {

/// The n-simplices on both sides of each facet with two that may vanish; -1 at others.
using Sides = std::vector<std::array<Index, 2>>;

/// What has to be known about the corners and facets of flat n-simplices; that of others does not
/// matter.
struct AroundFlat {
    Sides sides;
    Vector sizes;    ///< of facets: twice the circumradius; length
    Vector shortest; ///< edge at each vertex; length
};

/// Joins flat n-simplices with the class of neighbors on whose sphere they lie, within the
/// tolerance times the shortest edge at their corners. On the face between two cells they lie on
/// both spheres: they go to the smaller cell by volume, then by radius, and between equal ones to
/// that whose sorted corners come first in space, as far as they hang together with it; so the
/// choice depends neither on numbers nor on rounding. Which it is decides over pieces alone, not
/// over cells. Classes that flat simplices cut in two are joined before.
/// `flat` has a mark for each n-simplex. Flat simplices that hang together and the classes beside
/// them decide alone of what becomes of them, so that this may be done for a part of a complex that
/// has all of these.
void absorb_flat(const Geometry& geometry, const std::vector<bool>& flat, const AroundFlat& around,
                 double tolerance, DisjointSets& classes);

} // namespace polydec
