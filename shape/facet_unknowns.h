// SPDX-License-Identifier: MIT
#pragma once

#include "shape/gluing.h"

namespace polydec {

/// Unknowns of facets, a fixed number `each` per facet. Simplex s has width = each (n+1) entries;
/// its facet opposite corner i starts at width s + each i.
struct FacetUnknowns {
    Index count;
    std::vector<Index> unknowns; ///< -1 where functions are 0
    std::vector<std::int8_t> signs;
};

FacetUnknowns facet_unknowns(const Shape& shape, const std::vector<FacetSide>& sides, int each);

/// The weights of a simplex: kappa and rho.
double conductivity_of(const Shape& shape, Index simplex);
double density_of(const Shape& shape, Index simplex);

} // namespace polydec
