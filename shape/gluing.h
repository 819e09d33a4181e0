// SPDX-License-Identifier: MIT
#pragma once

#include "shape/barycentric.h"
#include "shape/shape.h"

#include <cstdint>
#include <vector>

namespace polydec {

/// A facet of an n-simplex of a shape, as its functions see it.
struct FacetSide {
    Index facet;
    std::int8_t sign;  ///< of its functions here: 1 but for twisted ones
    bool is_essential; ///< functions are 0 there
    double robin;      ///< coefficient; 0: none
};

/// The facets of all n-simplices: that of simplex s lacking corner i at (n+1) s + i. Throws
/// InvalidInput, naming the facet, for twisted functions where three simplices meet.
std::vector<FacetSide> facet_sides(const Shape& shape);

/// Which unknown the values of functions at points of simplices are: those at glued points are the
/// same, up to the sign of twisted functions.
struct GluedPoints {
    Index count = 0;                ///< of unknowns
    std::vector<Index> unknowns;    ///< simplex by simplex; -1: functions are 0 there
    std::vector<std::int8_t> signs; ///< of the value here against the unknown
};

/// The points (x_i + x_j) / 2 of pairs of corners, in the order of `pairs`: corners and midpoints
/// of edges. Glued are those of facets alone: what meets at a vertex only is apart.
GluedPoints glued_points(const Shape& shape, const std::vector<FacetSide>& sides,
                         const std::vector<Pair>& pairs);

/// Of each n-simplex the number of its component, by facets, if constants are free there: no facet
/// is essential or Robin's, and twisted functions can have one sign; -1 otherwise.
std::vector<Index> free_components(const Shape& shape);

} // namespace polydec
