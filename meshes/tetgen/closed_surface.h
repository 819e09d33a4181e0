// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <cstdint>
#include <vector>

namespace polydec {

/// Triangles in R^3 with every edge in two of them. Its parts consist of triangles that meet at
/// edges; two parts meet in vertices at most.
struct ClosedSurface {
    struct OddEdge {
        Index low, high; ///< its ends
        Index triangles; ///< how many have it
        Index first;     ///< the first one of them
    };
    std::vector<OddEdge> odd_edges; ///< those not in two triangles; if any, the rest means nothing
    Index twisted = -1; ///< a triangle of a part without inside and outside; then the same

    Simplices across;               ///< the neighbors of a triangle at its edges 01, 12 and 20
    std::vector<Index> part;        ///< of each triangle; parts are ordered by first triangles
    std::vector<std::int8_t> sense; ///< 1 if it turns left seen from outside, else -1
    std::vector<double> volumes;    ///< that each part encloses, positive
    double reach = 0.0;             ///< what errors of the volumes are relative to, length^3
};

ClosedSurface closed_surface(const Points& points, const Simplices& triangles);

/// How often each part turns around a place: 1 inside, 0 outside, one half on it.
std::vector<double> windings(const Points& points, const Simplices& triangles,
                             const ClosedSurface& surface, const Eigen::Vector3d& place);

} // namespace polydec
