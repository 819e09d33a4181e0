// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <span>
#include <vector>

namespace polydec {

/// Polygons in R^3 with every edge in two of them, part by part.
struct ClosedSurfaces {
    std::vector<Index> part;     ///< of each polygon; parts meet in vertices at most
    std::vector<bool> outward;   ///< of each polygon: whether it turns left seen from outside
    std::vector<double> volumes; ///< that each part encloses, positive
    double reach = 0.0;          ///< what errors of the volumes are relative to, length^3
    Index odd_edge = -1;         ///< a corner beside which an edge is not in two polygons; or -1
    Index twisted = -1;          ///< a polygon of a part that has no inside and outside; or -1
};

/// Takes apart polygons whose corners offsets[f] to offsets[f + 1] - 1 follow each other around
/// polygon f. What is found wrong is noted, and then the rest means nothing.
ClosedSurfaces closed_surfaces(const Points& points, std::span<const Index> corners,
                               std::span<const Index> offsets);

/// How often each part turns around a place: 1 inside, 0 outside, one half on it.
std::vector<double> windings(const Points& points, std::span<const Index> corners,
                             std::span<const Index> offsets, const ClosedSurfaces& surfaces,
                             const Eigen::Vector3d& place);

} // namespace polydec
