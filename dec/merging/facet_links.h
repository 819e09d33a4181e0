// SPDX-License-Identifier: MIT
#pragma once

#include "complex/disjoint_sets.h"

#include <span>

namespace polydec {

/// Limit, in tolerances, on a class's accumulated defects and on defects removed inside it.
constexpr double spread_limit = 10;

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
