// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

namespace polydec {

/// Coordinates of points in R^N in the n-plane that has them all, but for rounding: n columns, and
/// the same distances. Where n of the coordinates vary alone they are these. Without columns if
/// N = n, and if there is no such plane.
Points plane_points(const Points& points, int n);

} // namespace polydec
