// SPDX-License-Identifier: MIT
#pragma once

#include "dec/merging/merge.h"
#include "dec/metric/rounding.h"

#include <cmath>
#include <functional>

namespace polydec {

/// Distance of each facet's dual from zero extent.
struct FacetDefects {
    Geometry geometry;
    MergeCriterion criterion;
    Vector defect; ///< |V(f)| (length) beyond rounding, or the angle's distance from pi (radians)
    Vector scale;  ///< factor of the tolerance: l(f), or 1; where the defect is 0, or exceeds
                   ///< spread_limit tolerances, only a positive number or an upper bound
    DegenerateFacets degenerate; ///< defect within tolerance * scale, and see is_degenerate; none
                                 ///< at flat simplices
    std::vector<bool> flat;      ///< see flat_simplices; none by angles

    /// The defect over the true factor of the tolerance, of any facet.
    double ratio(Index facet) const;
};

/// Whether a dual edge is short beside a height: |V| <= height / 10.
inline bool is_short(double dual, double height) {
    constexpr double thin = 0.1;
    return std::abs(dual) <= thin * height;
}

/// Whether a dual edge counts as zero: |V| <= tolerance * l beyond its rounding error, l the size
/// of its facet, and |V| <= height / 10. The second condition keeps thin layers, whose centers are
/// as close to each other as their facets. A facet without extent has no such dual.
inline bool is_degenerate(double dual, double terms, double l, double height, double tolerance) {
    return l > 0 && std::abs(dual) <= tolerance * l + rounding_of(terms) && is_short(dual, height);
}

/// Calls take(f, height, terms) for every facet f of every n-simplex with nonzero volume. `height`
/// is the distance from the facet's circumcenter to the simplex's, positive towards the simplex;
/// `terms` is the scale of its error.
void for_each_height(const Geometry& geometry,
                     const std::function<void(Index, double, double)>& take);

/// Measures every facet, whatever its number of cofaces: the angles at a facet with m cofaces are
/// compared with m right angles. A facet without extent (a vertex, n = 1) is never degenerate.
FacetDefects facet_defects(const Geometry& geometry, const MergeOptions& options);

/// The same for known flat n-simplices.
FacetDefects facet_defects(const Geometry& geometry, const MergeOptions& options,
                           std::vector<bool> flat);

} // namespace polydec
