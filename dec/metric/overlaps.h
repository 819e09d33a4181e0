// SPDX-License-Identifier: MIT
#pragma once

#include "complex/pieces.h"

#include <cstdint>
#include <vector>

namespace polydec {

/// Places that a mesh of n-simplices in R^n covers twice, also in a plane of R^N in which all but n
/// coordinates are constant. Such a mesh is no part of space: volumes and duals are correct for its
/// cells, but not for the region that it appears to cover.
struct Overlaps {
    /// n-simplices on the wrong side, ascending. In a part connected across facets with two
    /// cofaces: simplices on the same side of such a facet as their neighbor, the fewer per part.
    /// At a branching facet: simplices on one side together with another.
    std::vector<Index> folded;
    /// Vertices of (n-2)-simplices around which the cells' angles sum to more than a full turn
    /// without a fold, e.g. cells that wind twice around a vertex of the plane. Ascending.
    std::vector<Index> wound;
};

/// Inspects every facet and the turns of the cells around every (n-2)-simplex. So the result
/// depends neither on numbering nor on axes, and around inner vertices every overlap without folds
/// is found. Anything within rounding (a cell that is flat to the last digits) is ignored. Linear
/// time; products of n lengths must not overflow or underflow. Empty unless n coordinates vary.
/// Throws InvalidInput unless there is one point per vertex.
///
/// For a part of a larger complex: `against` marks the simplices that belong to the smaller halves
/// there.
Overlaps find_overlaps(const Pieces& complex, const Points& points,
                       const std::vector<bool>& against = {});

/// The side on which each n-simplex lies: the sign of the determinant of its edges from its first
/// corner, 0 within rounding. Points have n coordinates.
std::vector<std::int8_t> sides(const Pieces& complex, const Points& points);

} // namespace polydec
