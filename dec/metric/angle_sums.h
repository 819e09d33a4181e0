// SPDX-License-Identifier: MIT
#pragma once

#include "complex/pieces.h"
#include "dec/metric/simplex_layout.h"

#include <functional>

namespace polydec {

/// Calls take(t, i, s, angle) for every n-simplex t and its (n-2)-face s, which is number i in
/// SimplexFaces(complex, n, n-2).of(t): the angle between the facets that have s, n >= 2. Omits
/// simplices that are flat to the last digits. Radians.
void for_each_angle(const Pieces& complex, const SimplexMetric& metric,
                    const std::function<void(Index, Index, Index, double)>& take);

/// Sums of the angles of the n-simplices around each (n-2)-simplex, n >= 2: 2 pi in the interior of
/// a flat complex, pi on a plane boundary. Simplices that are flat to the last digits do not
/// contribute. Size size(n-2); radians.
Vector angle_sums(const Pieces& complex, const SimplexMetric& metric);

} // namespace polydec
