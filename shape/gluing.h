// SPDX-License-Identifier: MIT
#pragma once

#include "shape/barycentric.h"
#include "shape/shape.h"

#include <cstdint>
#include <vector>

namespace polydec {

/// A facet of an n-simplex of a shape, as functions on the simplex see it.
struct FacetSide {
    Index facet;
    std::int8_t sign;  ///< of functions on this side; always 1 for ordinary ones
    bool is_essential; ///< functions vanish there
    double robin;      ///< coefficient; 0: none
};

/// The facets of all n-simplices: the facet of simplex s opposite corner i is entry (n+1) s + i.
/// Throws InvalidInput, naming the facet, for twisted functions if three simplices meet there.
std::vector<FacetSide> facet_sides(const Shape& shape);

/// The unknowns for values of functions at points of simplices. Values at glued points are equal,
/// up to the sign of twisted functions.
struct GluedPoints {
    Index count = 0;                ///< of unknowns
    std::vector<Index> unknowns;    ///< simplex by simplex; -1: functions vanish there
    std::vector<std::int8_t> signs; ///< of the value here relative to the unknown
};

/// The points (x_i + x_j) / 2 of pairs of corners, in the order of `pairs`: corners and midpoints
/// of edges. Gluing acts through facets: at a shared vertex alone, points stay separate.
GluedPoints glued_points(const Shape& shape, const std::vector<FacetSide>& sides,
                         const std::vector<Pair>& pairs);

/// The component, connected through facets, of each n-simplex; -1 unless constants are free there:
/// no facet is essential or Robin, and twisted functions can have one sign.
std::vector<Index> free_components(const Shape& shape);

} // namespace polydec
