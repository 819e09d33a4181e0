// SPDX-License-Identifier: MIT
#pragma once

#include "complex/disjoint_sets.h"

#include <span>

namespace polydec {

/// Limit, in tolerances, on a class's accumulated defects and on defects removed inside it.
constexpr double spread_limit = 10;

/// Relative defects closer than this count as equal: in symmetric meshes they are equal up to
/// rounding.
constexpr double tie = 1e-12;

/// Whether a facet with this relative defect is restored where the cell that removed it is no ball:
/// all within a factor of two of the worst, so that the choice depends neither on numbering nor on
/// rounding. If the worst is rounding, all are restored, as if all defects were 0.
inline bool is_among_the_worst(double relative_defect, double worst) {
    return relative_defect >= worst / 2 - tie;
}

/// A degenerate facet across which the n-simplices a and b may become one cell.
struct FacetLink {
    Index a, b;
    double defect, scale;  ///< see FacetDefects
    int relative_sign = 1; ///< see Sides
};

/// Joins classes of n-simplices across links in ascending relative defect; links without defect may
/// be joined already. Connected links with equal defect are joined all or none. The defects
/// accumulated by a class stay within spread_limit tolerances of each facet between. The result for
/// connected links depends only on these and their order, so a part of all links gives the same
/// classes. Time O(f log f) in the number of links with a defect, else near-linear.
void join_links(std::span<const FacetLink> links, double tolerance, DisjointSets& classes);

} // namespace polydec
