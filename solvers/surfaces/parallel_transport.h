// SPDX-License-Identifier: MIT
#pragma once

#include "base/shared.h"
#include "complex/surfaces/glued_surface.h"

#include <span>
#include <string>
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

/// A tangent vector for every vertex, in the coordinates of the surface's TangentFrames.
using TangentVectors = Column<std::complex<double>>;

struct TransportOptions {
    double time_scale = 4; ///< diffusion time over the squared mean edge length
    std::string linear_solver = "auto";
};

/// Transports vectors from some vertices of a two-sided surface along shortest paths to all other
/// vertices by the vector heat method, with two factorizations for all sources. The vector heat
/// flow gives the directions; two scalar heat flows give magnitudes, which come from the nearest
/// source. No heat flows through the boundary (Neumann). As in GeodesicDistance, the time is
/// extended where heat would be too faint.
/// Source: Sharp, Soliman, Crane, The Vector Heat Method, ACM Trans. Graph. 38(3), 2019.
class ParallelTransport {
public:
    /// Takes one length per edge. Throws InvalidInput like tangent_frames, and unless the time
    /// scale is from 1e-6 to 1e6; SolverFailure if the engine cannot factorize.
    ParallelTransport(const GluedSurface& surface, const Vector& lengths,
                      const TransportOptions& options = {});

    /// The coordinates of vectors, both input and output.
    const TangentFrames& frames() const&;
    TangentFrames frames() && { return frames(); }

    /// Extends one vector per source to a vector at every vertex. Magnitudes lie between the
    /// smallest and the largest given. Where vectors from several sources cancel to rounding, the
    /// direction is undefined and the vector is 0. At a source the result is near the given vector;
    /// nearby sources mix with it. Throws InvalidInput for a source that is not a vertex or is
    /// repeated; for a component without source, naming a vertex; for a wrong number of vectors, or
    /// vectors that are not finite; SolverFailure if the engine fails.
    TangentVectors extend(std::span<const Index> sources, const TangentVectors& vectors) const;

private:
    struct Parts;
    Shared<Parts> parts_;
};

} // namespace polydec
