// SPDX-License-Identifier: MIT
#pragma once

#include "complex/pieces.h"
#include "dec/metric/simplex_layout.h"

namespace polydec {

/// Sums of the angles of the n-simplices around each (n-2)-simplex, n >= 2: 2 pi in the interior of
/// a flat complex, pi on a plane boundary. Simplices that are flat to the last digits do not
/// contribute. Size size(n-2); radians.
Vector angle_sums(const Pieces& complex, const SimplexMetric& metric);

} // namespace polydec
