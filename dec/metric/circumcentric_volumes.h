// SPDX-License-Identifier: MIT
#pragma once

#include "dec/metric/geometry.h"

namespace polydec {

/// Volumes of the simplices and signed volumes of their circumcentric duals, by the recursion |*s|
/// = 1/(n-k) sum over cofaces t of h(s,t) |*t|, h the signed distance between the circumcenters.
/// Needs no manifold and no Delaunay property; sum |s||*s| = C(n,k) |K| always. Needs only lengths
/// of edges. Source: Hirani, Kalyanaraman, VanderZee 2013, with the sign taken from the coface,
/// which is correct for obtuse simplices too. Throws InvalidInput, naming the vertices, for a
/// simplex without volume, for vertices without point, and for a simplex of least dimension that
/// cannot have the given lengths (a triangle that violates the triangle inequality; in higher
/// dimensions, edges whose Gram matrix is not positive definite).
CellVolumes circumcentric_volumes(const Pieces& complex, const SimplexMetric& metric);

/// The same with duals between other centers. Throws likewise, and for centers of other simplices.
/// If the centers know the heights in n-simplices, these simplices may also be flat.
CellVolumes dual_volumes(const Pieces& complex, const SimplexMetric& metric, const Centers& centers,
                         FlatSimplices flat = FlatSimplices::refused);

} // namespace polydec
