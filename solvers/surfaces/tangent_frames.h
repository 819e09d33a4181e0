// SPDX-License-Identifier: MIT
#pragma once

#include "complex/surfaces/glued_surface.h"

#include <vector>

namespace polydec {

/// Polar coordinates for tangent vectors at the vertices of a surface of which the lengths alone
/// are known: a vector is a complex number, whose argument is its angle from a reference half-edge
/// of the vertex, in the direction in which the triangles are oriented. Around an inner vertex
/// angles are stretched so that their sum is 2 pi; around a boundary vertex they are as they are,
/// so that flat surfaces stay flat up to their boundary.
struct TangentFrames {
    std::vector<Index> reference; ///< of vertices: a half-edge from it, which has angle 0. On the
                                  ///< boundary the one that has the surface to its side of angles
                                  ///< above 0; inside the one of least number
    Vector at_tail; ///< of half-edges: the angle at its tail of the direction along it
    Vector at_head; ///< of half-edges: the angle at its head of the direction back along it
    Vector sums;    ///< of vertices: the sum of the angles around it, not stretched. What an inner
                    ///< vertex lacks to 2 pi is its curvature

    /// The vector of length 1 along a half-edge, at its tail.
    std::complex<double> direction(Index halfedge) const {
        return std::polar(1.0, at_tail[halfedge]);
    }

    /// The factor of absolute value 1 that carries vectors along a half-edge from tail to head.
    std::complex<double> carried(Index halfedge) const {
        return -std::polar(1.0, at_head[halfedge] - at_tail[halfedge]);
    }
};

/// The frames of a surface with a length for every edge.
/// Source: Knoeppel, Crane, Pinkall, Schroeder, Globally Optimal Direction Fields, ACM Trans.
/// Graph. 32(4), 2013, sec. 6.
/// Throws InvalidInput, naming edge or triangle, for lengths that are none of triangles with area;
/// naming the edge, if triangles at an edge are not oriented alike; and, naming the vertex, if the
/// triangles around it are several fans.
TangentFrames tangent_frames(const GluedSurface& surface, const Vector& lengths);

} // namespace polydec
