// SPDX-License-Identifier: MIT
#pragma once

#include "complex/disjoint_sets.h"

#include <span>

namespace polydec {

/// What a class may gather, and what still may be removed inside one, in tolerances.
constexpr double spread_limit = 10;

/// A degenerate facet across which the n-simplices a and b may become one cell.
struct FacetLink {
    Index a, b;
    double defect, scale; ///< see FacetDefects
};

/// Classes of the n-simplices 0 .. size-1: joined across links in ascending relative defect, those
/// that tie and hang together all or none, as long as the defects that a class has gathered stay
/// within spread_limit tolerances of each facet between. Links that hang together decide alone of
/// what becomes of them, in the order in which they are given, so that a part of all links has the
/// same classes. Time O(f log f) in the number of links with a defect, else near-linear.
DisjointSets join_links(Index size, std::span<const FacetLink> links, double tolerance);

} // namespace polydec
