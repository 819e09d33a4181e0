// SPDX-License-Identifier: MIT
#pragma once

#include "complex/pieces.h"
#include "dec/metric/cell_volumes.h"
#include "dec/metric/centers.h"
#include "dec/metric/simplex_metric.h"

namespace polydec {

/// Volumes of the simplices and signed volumes of their circumcentric duals, by the recursion
/// |*s| = 1/(n-k) sum over cofaces t of h(s,t) |*t| with h the signed distance between the
/// circumcenters. Needs no manifold and no Delaunay property; sum |s||*s| = C(n,k) |K| always.
/// Needs lengths of edges only. Source: Hirani, Kalyanaraman, VanderZee 2013, with the sign
/// taken from the coface, which makes it right for obtuse simplices too.
/// Throws InvalidInput, naming the vertices, for a simplex without volume, vertices without point,
/// or a simplex of least dimension that cannot have the lengths given (a triangle that violates the
/// triangle inequality, in higher dimension edges whose products are not positive definite).
CellVolumes circumcentric_volumes(const Pieces& complex, const SimplexMetric& metric);

/// What becomes of n-simplices without volume.
enum class FlatSimplices {
    refused,
    passed_over, ///< they have no part in any dual, and a volume that cannot be told from none
};

/// The same with duals between other centers. Throws likewise, and for centers of other simplices.
/// Where centers know the heights in n-simplices, these may have no volume, too.
CellVolumes dual_volumes(const Pieces& complex, const SimplexMetric& metric, const Centers& centers,
                         FlatSimplices flat = FlatSimplices::refused);

} // namespace polydec
