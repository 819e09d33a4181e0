// SPDX-License-Identifier: MIT
#pragma once

#include "solvers/surfaces/tangent_frames.h"

#include <memory>
#include <span>
#include <string>

namespace polydec {

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
    ParallelTransport(ParallelTransport&&) noexcept;
    ~ParallelTransport();

    /// The coordinates of vectors, both input and output.
    const TangentFrames& frames() const;

    /// Extends one vector per source to a vector at every vertex. Magnitudes lie between the
    /// smallest and the largest given. Where vectors from several sources cancel to rounding, the
    /// direction is undefined and the vector is 0. At a source the result is near the given vector;
    /// nearby sources mix with it. Throws InvalidInput for a source that is not a vertex or is
    /// repeated; for a component without source, naming a vertex; for a wrong number of vectors, or
    /// vectors that are not finite; SolverFailure if the engine fails.
    TangentVectors extend(std::span<const Index> sources, const TangentVectors& vectors) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// The vectors, with a solver made for them; their coordinates are tangent_frames(surface,
/// lengths).
TangentVectors transported(const GluedSurface& surface, const Vector& lengths,
                           std::span<const Index> sources, const TangentVectors& vectors,
                           const TransportOptions& options = {});

} // namespace polydec
