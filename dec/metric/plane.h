// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <vector>

namespace polydec {

/// The coordinates that are not constant.
std::vector<Eigen::Index> varying_coordinates(const Points& points);

/// Coordinates of points in R^N within the n-plane that contains them up to rounding: n columns,
/// same distances. If only n coordinates vary, these. Without columns if N = n, and if there is no
/// such plane.
Points plane_points(const Points& points, int n);

} // namespace polydec
