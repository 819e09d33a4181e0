// SPDX-License-Identifier: MIT
#pragma once

#include "complex/pieces.h"
#include "dec/metric/simplex_metric.h"

namespace polydec {

/// The angles of the n-simplices around each (n-2)-simplex, n >= 2, added up: 2 pi inside of what
/// is flat, pi on a plane boundary. Simplices that are flat to the last digits have none. Size
/// size(n-2); radians.
Vector angle_sums(const Pieces& complex, const SimplexMetric& metric);

} // namespace polydec
