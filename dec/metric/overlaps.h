// SPDX-License-Identifier: MIT
#pragma once

#include "complex/pieces.h"

#include <vector>

namespace polydec {

/// Where a mesh of n-simplices in R^n, or in a plane of R^N on which all coordinates but n are
/// constant, covers a place twice, so that it is no part of space: volumes
/// and duals are still those of its cells, but not those of the region that they look like.
struct Overlaps {
    /// n-simplices on the wrong side: of parts connected across facets with two cofaces, those that
    /// lie on the same side of such a facet as their neighbor, the smaller number of each part; and
    /// those on one side of a branching facet together with another. Ascending.
    std::vector<Index> folded;
    /// Vertices of (n-2)-simplices around which the angles of the cells add up to more than a full
    /// turn, without a fold, as they do where cells wind around a vertex of the plane twice.
    /// Ascending.
    std::vector<Index> wound;
};

/// Looks at every facet, and adds up the angles around every (n-2)-simplex: so neither numbers nor
/// axes matter, and around inner vertices every overlap without folds is found. What is no more
/// than rounding (a cell that is flat to the last digits) speaks neither for nor against. Linear
/// time; products of n lengths must be ordinary numbers. Empty unless n coordinates vary.
/// Throws InvalidInput unless there is a point for each vertex.
Overlaps find_overlaps(const Pieces& complex, const Points& points);

} // namespace polydec
