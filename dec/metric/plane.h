// SPDX-License-Identifier: MIT
#pragma once

#include "dec/metric/simplex_metric.h"

#include <memory>
#include <vector>

namespace polydec {

/// The coordinates that are not constant.
std::vector<Eigen::Index> varying_coordinates(const Points& points);

/// Coordinates of points in R^N within the n-plane that contains them up to the last digits of
/// their coordinates: n columns. Without columns if N = n, and if there is no such plane.
struct PlanePoints {
    Points points;
    double error = 0; ///< bound on how far they are, moved rigidly, from the points given
};

/// If only n coordinates vary, these, without error; else those along orthonormal axes.
PlanePoints plane_points(const Points& points, int n);

/// The metric of these points. If they lie in an n-plane, it uses their coordinates there, unless
/// their error is more than 1e-11 of the shortest edge: rounding in the plane would spoil details
/// that are far smaller than the coordinates.
SimplexMetric metric_in_plane(const Pieces& complex, const std::shared_ptr<const Points>& points);

} // namespace polydec
