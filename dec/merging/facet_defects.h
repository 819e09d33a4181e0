// SPDX-License-Identifier: MIT
#pragma once

#include "dec/merging/merge.h"

#include <functional>

namespace polydec {

/// Distance of each facet's dual from zero extent.
struct FacetDefects {
    Vector defect; ///< |V(f)| (length) beyond rounding, or the angle's distance from pi (radians)
    Vector scale;  ///< factor of the tolerance: l(f), or 1
    DegenerateFacets degenerate; ///< defect within tolerance * scale, and see is_degenerate; none
                                 ///< at flat simplices
    std::vector<bool> flat;      ///< see flat_simplices; none by angles

    double ratio(Index facet) const { return defect[facet] / scale[facet]; }
};

/// Whether a dual edge counts as zero: |V| <= tolerance * l beyond its rounding error, l the size
/// of its facet, and |V| <= height / 10. The second condition keeps thin layers, whose centers are
/// as close to each other as their facets. A facet without extent has no such dual.
bool is_degenerate(double dual, double terms, double l, double height, double tolerance);

/// Calls take(f, height, terms) for every facet f of every n-simplex with nonzero volume. `height`
/// is the distance from the facet's circumcenter to the simplex's, positive towards the simplex;
/// `terms` is the scale of its error.
void for_each_height(const Geometry& geometry,
                     const std::function<void(Index, double, double)>& take);

/// Least height n |t| / |f| over each facet of the n-simplices not marked as flat; length. Infinite
/// where there are none.
Vector least_heights(const Pieces& complex, const CellVolumes& volumes,
                     const std::vector<bool>& flat);

/// Measures every facet, whatever its number of cofaces: the angles at a facet with m cofaces are
/// compared with m right angles. A facet without extent (a vertex, n = 1) is never degenerate.
FacetDefects facet_defects(const Geometry& geometry, const MergeOptions& options);

/// The same for known flat n-simplices.
FacetDefects facet_defects(const Geometry& geometry, const MergeOptions& options,
                           std::vector<bool> flat);

} // namespace polydec
