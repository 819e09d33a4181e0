// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"

#include <memory>
#include <span>
#include <string>

namespace polydec {

struct GeodesicOptions {
    double time_scale = 4; ///< the heat flows for this times the squared mean edge length
    std::string linear_solver = "auto";
};

/// Distances of vertices, and how many of them were raised to 0.
struct Distance {
    Vector values;
    Index raised;
    std::vector<std::string> warnings = {}; ///< why they may be far off
};

/// Distance along a surface by the heat method. Heat flows from the sources for a short time; the
/// gradient of its logarithm, made a unit vector in every triangle, points towards them; the
/// distance is the function that is 0 at the sources and whose gradient fits the opposite best. The
/// surface may be bounded, one-sided, of several components, and branch: each triangle has a plane
/// of its own, so any number of them may meet at an edge. Two factorizations serve all calls with
/// one source on each component; several there cost one for each call.
///
/// Where the time is so short that the heat far away is too faint for its digits to be trusted, it
/// flows longer, on that component and for that call. With a direct engine this begins at some 500
/// edges from the sources; with one that iterates, at 18.
/// Source: Crane, Weischedel, Wardetzky, Geodesics in Heat, ACM Trans. Graph. 32(5), 2013; the
/// logarithm is ours.
class GeodesicDistance {
public:
    /// A length for every edge. Throws InvalidInput, naming edge or triangle, for lengths that are
    /// none of triangles with area, and unless the time scale is from 1e-6 to 1e6; SolverFailure if
    /// the engine cannot factorize.
    GeodesicDistance(const Triangles& surface, const Vector& lengths,
                     const GeodesicOptions& options = {});
    /// On the surface of a bundle, after intrinsic flips on the flipped triangles.
    /// Throws InvalidInput too if it is no surface.
    GeodesicDistance(const Discretization& discretization, const GeodesicOptions& options = {});
    GeodesicDistance(GeodesicDistance&&) noexcept;
    ~GeodesicDistance();

    /// The distance of every vertex from the nearest of the source vertices, in the unit of the
    /// lengths, of a mesh in that of its input. 0 at the sources. Triangles far from Delaunay can
    /// bring values below 0, which are raised to 0 and counted. Throws InvalidInput for a source
    /// that is no vertex, and, naming a vertex, if a component has no source; SolverFailure if the
    /// engine does not deliver.
    Distance to(std::span<const Index> sources) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
    std::vector<std::string> warnings_; // of the mesh
    std::string advice_;                // on negative duals
    double unit_ = 1;                   // that the mesh is measured in
};

/// The distance by a solver made for it.
Vector geodesic_distance(const Triangles& surface, const Vector& lengths,
                         std::span<const Index> sources, const GeodesicOptions& options = {});

/// The distance on the surface of a bundle, of the 0-cells of complex() from those given; after
/// intrinsic flips on the flipped triangles, where it is more accurate if the input's are bad.
/// Throws InvalidInput too if the bundle is no surface.
Vector geodesic_distance(const Discretization& discretization, std::span<const Index> sources,
                         const GeodesicOptions& options = {});

} // namespace polydec
