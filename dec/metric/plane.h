// SPDX-License-Identifier: MIT
#pragma once

#include "dec/metric/simplex_metric.h"

#include <memory>
#include <vector>

namespace polydec {

/// The coordinates that are not constant.
std::vector<Eigen::Index> varying_coordinates(const Points& points);

/// Coordinates of points in R^N within the n-plane that contains them up to rounding: n columns,
/// same distances. If only n coordinates vary, these. Without columns if N = n, and if there is no
/// such plane.
Points plane_points(const Points& points, int n);

/// The metric of these points. If they lie in an n-plane, it uses their coordinates there, unless
/// these change the length of an edge by more than 1e-12 of it: rounding in the plane would spoil
/// details that are far smaller than the coordinates.
SimplexMetric metric_in_plane(const Pieces& complex, const std::shared_ptr<const Points>& points);

} // namespace polydec
