// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"

#include <memory>
#include <span>
#include <string>

namespace polydec {

enum class DistanceMethod {
    exact, ///< the length of a shortest path, up to rounding (see exact_distance)
    heat   ///< smoothed: by two linear systems, off by some percent of the greatest distance
};

/// "exact" or "heat".
const char* name(DistanceMethod method);

struct GeodesicOptions {
    DistanceMethod method = DistanceMethod::exact;
    double time_scale = 4; ///< the heat flows for this times the squared mean edge length
    std::string linear_solver = "auto"; ///< of the heat method
};

/// Distances of vertices, and how many of them were raised to 0.
struct Distance {
    Vector values;
    Index raised;                           ///< none of exact ones
    std::vector<std::string> warnings = {}; ///< why they may be far off
};

/// Distance along a surface, which may be bounded, one-sided, of several components, and branch.
///
/// The exact distance is a property of the shape: it does not depend on how that is divided into
/// triangles. The heat method gives a smooth function near it, and factorizations serve many calls:
/// two serve all of one source on each component; several there cost two for each call. Heat flows
/// from the sources, which are held at one temperature, for a short time; the gradient of its
/// logarithm, made a unit vector in every triangle, points towards them; the distance is the
/// function that is 0 at the sources and whose gradient fits the opposite best. On scans and
/// generated surfaces it is off by 1 to 3 % of the greatest distance on average, and by 2 to 15 %
/// at most, where shortest paths from several sides meet; near a corner of the boundary that is its
/// source by 40 % of the distance there.
class GeodesicDistance {
public:
    /// A length for every edge. Throws InvalidInput, naming edge or triangle, for lengths that are
    /// none of triangles with area; for options of the heat method without it, and unless the time
    /// scale is from 1e-6 to 1e6; SolverFailure if the engine cannot factorize.
    GeodesicDistance(const Triangles& surface, const Vector& lengths,
                     const GeodesicOptions& options = {});
    /// On the surface of a bundle, after intrinsic flips on the flipped triangles.
    /// Throws InvalidInput too if it is no surface.
    GeodesicDistance(const Discretization& discretization, const GeodesicOptions& options = {});
    GeodesicDistance(GeodesicDistance&&) noexcept;
    ~GeodesicDistance();

    /// The distance of every vertex from the nearest of the source vertices, in the unit of the
    /// lengths, of a mesh in that of its input. 0 at the sources. By the heat method, triangles far
    /// from Delaunay can bring values below 0, which are raised to 0 and counted. Throws
    /// InvalidInput for a source that is no vertex, and, naming a vertex, if a component has no
    /// source or numbers are out of range; SolverFailure if an engine does not deliver, or if exact
    /// distances need too many windows.
    Distance to(std::span<const Index> sources) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
    std::vector<std::string> warnings_; // of the mesh, for the heat method
    std::string advice_;                // on negative duals
    double unit_ = 1;                   // that the mesh is measured in
};

/// The distance by a solver made for it.
Vector geodesic_distance(const Triangles& surface, const Vector& lengths,
                         std::span<const Index> sources, const GeodesicOptions& options = {});

/// The distance on the surface of a bundle, of the 0-cells of complex() from those given; after
/// intrinsic flips on the flipped triangles, where the heat method is more accurate if the input's
/// are bad. Throws InvalidInput too if the bundle is no surface.
Vector geodesic_distance(const Discretization& discretization, std::span<const Index> sources,
                         const GeodesicOptions& options = {});

} // namespace polydec
