// SPDX-License-Identifier: MIT
#pragma once

#include "complex/surfaces/glued_surface.h"

#include <vector>

namespace polydec {

/// Polar coordinates for tangent vectors at the vertices of a surface given by lengths alone. A
/// vector is a complex number; its argument is its angle from a reference half-edge of the vertex,
/// positive in the orientation of the triangles. Around an interior vertex, angles are scaled so
/// that their sum is 2 pi; around a boundary vertex they are not scaled, so that flat surfaces stay
/// flat up to their boundary.
struct TangentFrames {
    std::vector<Index> reference; ///< of vertices: the outgoing half-edge of angle 0; on the
                                  ///< boundary, the one with the surface on the side of positive
                                  ///< angles; inside, the one with the least number
    Vector at_tail;               ///< of half-edges: the angle of its direction at its tail
    Vector at_head; ///< of half-edges: the angle at its head of the reversed direction
    Vector sums;    ///< of vertices: the unscaled sum of the angles around; 2 pi minus it is the
                    ///< curvature of an interior vertex

    /// The unit vector along a half-edge, at its tail.
    std::complex<double> direction(Index halfedge) const {
        return std::polar(1.0, at_tail[halfedge]);
    }

    /// The unit complex factor that transports vectors along a half-edge from tail to head.
    std::complex<double> carried(Index halfedge) const {
        return -std::polar(1.0, at_head[halfedge] - at_tail[halfedge]);
    }
};

/// The frames of a surface with one length per edge. Source: Knoeppel, Crane, Pinkall, Schroeder,
/// Globally Optimal Direction Fields, ACM Trans. Graph. 32(4), 2013, sec. 6. Throws InvalidInput,
/// naming edge or triangle, unless the lengths form triangles with area; naming the edge, if
/// adjacent triangles are not consistently oriented; naming the vertex, if the triangles around it
/// form several fans.
TangentFrames tangent_frames(const GluedSurface& surface, const Vector& lengths);

} // namespace polydec
