// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <cstdint>
#include <vector>

namespace polydec {

/// Triangles in R^3 with two triangles at every edge. A part consists of triangles connected
/// through edges; two parts share at most vertices.
struct ClosedSurface {
    struct OddEdge {
        Index low, high; ///< its ends
        Index triangles; ///< number of triangles at it
        Index first;     ///< first triangle at it
    };
    std::vector<OddEdge> odd_edges; ///< edges not in two triangles; if any, the rest is invalid
    Index twisted = -1;             ///< a triangle of a one-sided part; if any, the rest is invalid

    Simplices across;               ///< the neighbors of a triangle at its edges 01, 12 and 20
    std::vector<Index> part;        ///< of each triangle; parts in order of their first triangles
    std::vector<std::int8_t> sense; ///< 1 if counterclockwise seen from outside, else -1
    std::vector<double> volumes;    ///< enclosed by each part, positive
    double reach = 0.0;             ///< scale of the rounding errors of the volumes, length^3
};

ClosedSurface closed_surface(const Points& points, const Simplices& triangles);

/// The winding number of each part around a point: 1 inside, 0 outside, one half on it.
std::vector<double> windings(const Points& points, const Simplices& triangles,
                             const ClosedSurface& surface, const Eigen::Vector3d& place);

} // namespace polydec
