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
    bool is_boundary;
    std::int8_t sign;  ///< of functions on this side; always 1 for ordinary ones
    bool is_essential; ///< functions vanish there
    double robin;      ///< coefficient; 0: none
};

/// The facets of all n-simplices: the facet of simplex s opposite corner i is entry (n+1) s + i.
/// Throws InvalidInput, naming the facet, for twisted functions if three simplices meet there.
std::vector<FacetSide> facet_sides(const Shape& shape);

/// The unknowns for values of functions at points or facets of simplices, the same number for each
/// simplex. Values that are glued are equal, up to the sign of twisted functions.
struct Unknowns {
    Index count = 0;
    std::vector<Index> of_simplices = {}; ///< simplex by simplex; -1: functions vanish there
    std::vector<std::int8_t> signs = {};  ///< of the value here relative to the unknown
};

/// At the points (x_i + x_j) / 2 of pairs of corners, in the order of `pairs`: corners and
/// midpoints of edges. Gluing acts through facets: at a shared vertex alone, points stay separate.
Unknowns glued_points(const Shape& shape, const std::vector<FacetSide>& sides,
                      const std::vector<Pair>& pairs);

/// Unknowns of facets, a fixed number `each` per facet. Simplex s has width = each (n+1) entries;
/// its facet opposite corner i starts at width s + each i.
Unknowns facet_unknowns(const Shape& shape, const std::vector<FacetSide>& sides, int each);

/// The weights of a simplex: kappa and rho.
double conductivity_of(const Shape& shape, Index simplex);
double density_of(const Shape& shape, Index simplex);

/// The component, connected through facets, of each n-simplex; -1 unless constants are free there:
/// no facet is essential or Robin, and twisted functions can have one sign.
std::vector<Index> free_components(const Shape& shape);

} // namespace polydec
