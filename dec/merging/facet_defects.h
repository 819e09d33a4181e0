// SPDX-License-Identifier: MIT
#pragma once

#include "dec/merging/merge.h"

#include <functional>

namespace polydec {

/// How far each facet's dual is from having no extent.
struct FacetDefects {
    Vector defect; ///< |V(f)| (length) beyond rounding, or the angle's distance from pi (radians)
    Vector scale;  ///< what the tolerance multiplies: l(f), or 1
    DegenerateFacets degenerate; ///< defect within tolerance * scale, and see is_degenerate; none
                                 ///< at flat simplices
    std::vector<bool> flat;      ///< see flat_simplices; none by angles

    double ratio(Index facet) const { return defect[facet] / scale[facet]; }
};

/// Whether a dual edge counts as nothing: |V| <= tolerance * l beyond its rounding error, l the
/// size of its facet, and |V| <= height / 10, so that thin layers, whose centers are as near to
/// each other as their facets, stay layers. A facet without extent has no such dual.
bool is_degenerate(double dual, double terms, double l, double height, double tolerance);

/// Calls take(f, height, terms) for every facet f of every n-simplex that has a volume: how far the
/// circumcenter of the simplex lies from that of the facet, positive towards the simplex, and to
/// what the error of that is in proportion.
void for_each_height(const Geometry& geometry,
                     const std::function<void(Index, double, double)>& take);

/// Least height n |t| / |f| of the n-simplices over each facet that are not marked as flat; length.
/// Infinite where there are none.
Vector least_heights(const Pieces& complex, const CellVolumes& volumes,
                     const std::vector<bool>& flat);

/// Measures every facet, whatever its number of cofaces: one with m cofaces is compared with m
/// right angles. A facet without extent (a vertex, n = 1) is never degenerate.
FacetDefects facet_defects(const Geometry& geometry, const MergeOptions& options);

/// The same, where it is known which n-simplices are flat.
FacetDefects facet_defects(const Geometry& geometry, const MergeOptions& options,
                           std::vector<bool> flat);

} // namespace polydec
