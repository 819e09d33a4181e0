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
    double time_scale = 4; ///< the heat flows for this times the squared mean edge length
    std::string linear_solver = "auto";
};

/// Vectors at some vertices of a two-sided surface, carried in parallel along shortest ways to all
/// others by the vector heat method, with two factorizations for all sources. Heat that is vectors
/// gives the directions; magnitudes are those of the nearest source, by two flows of ordinary heat.
/// No heat flows through the boundary (Neumann). As for GeodesicDistance, the heat flows longer
/// where it would be too faint.
/// Source: Sharp, Soliman, Crane, The Vector Heat Method, ACM Trans. Graph. 38(3), 2019.
class ParallelTransport {
public:
    /// A length for every edge. Throws InvalidInput for what tangent_frames refuses and unless the
    /// time scale is from 1e-6 to 1e6; SolverFailure if the engine cannot factorize.
    ParallelTransport(const GluedSurface& surface, const Vector& lengths,
                      const TransportOptions& options = {});
    ParallelTransport(ParallelTransport&&) noexcept;
    ~ParallelTransport();

    /// The coordinates in which vectors are taken and given.
    const TangentFrames& frames() const;

    /// A vector at every vertex from one at each source. Magnitudes are between the least and the
    /// largest given. Where vectors from several sources cancel to rounding, there is no direction,
    /// and the vector is 0. At a source the result is near what is given there; the nearer other
    /// sources are, the more it mixes with theirs.
    /// Throws InvalidInput for a source that is no vertex or is given twice, a component without
    /// source, naming a vertex, a wrong number of vectors, or vectors that are not finite;
    /// SolverFailure if the engine does not deliver.
    TangentVectors extend(std::span<const Index> sources, const TangentVectors& vectors) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

/// The vectors by a solver made for them; express them with tangent_frames(surface, lengths).
TangentVectors transported(const GluedSurface& surface, const Vector& lengths,
                           std::span<const Index> sources, const TangentVectors& vectors,
                           const TransportOptions& options = {});

} // namespace polydec
