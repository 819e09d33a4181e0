// SPDX-License-Identifier: MIT
#pragma once

#include "dec/merge.h"

namespace polydec {

/// How far each facet's dual is from having no extent.
struct FacetDefects {
    Vector defect; ///< |V(f)| (length) beyond rounding, or the angle's distance from pi (radians)
    Vector scale;  ///< what the tolerance multiplies: l(f), or 1
    std::vector<bool> degenerate; ///< defect within tolerance * scale

    double ratio(Index facet) const { return defect[facet] / scale[facet]; }
};

/// Measures every facet, whatever its number of cofaces: one with m cofaces is compared with m
/// right angles. A facet without extent (a vertex, n = 1) is never degenerate.
FacetDefects facet_defects(const SimplicialComplex& complex, const SimplexMetric& metric,
                           const CellVolumes& volumes, const MergeOptions& options);

/// Rounding error that a dual length can have by the shape of the simplices around it: 64 eps
/// (R/l)^2 l, with circumradius R and length l.
double dual_length_rounding(double circumradius, double length);

} // namespace polydec
