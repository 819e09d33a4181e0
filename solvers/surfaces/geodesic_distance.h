// SPDX-License-Identifier: MIT
#pragma once

#include "base/progress.h"
#include "base/shared.h"
#include "complex/surfaces/glued_surface.h"
#include "dec/discretization/discretization.h"
#include "meshes/level_sets.h"
#include "shape/geodesics.h"

#include <span>
#include <string>

namespace polydec {

enum class DistanceMethod {
    exact, ///< the length of a shortest path, up to rounding (see exact_distance)
    heat   ///< smoothed: by two linear systems, error a few percent of the greatest distance
};

/// "exact" or "heat".
const char* name(DistanceMethod method);

struct GeodesicOptions {
    DistanceMethod method = DistanceMethod::exact;
    double time_scale = 4;              ///< diffusion time over the squared mean edge length
    std::string linear_solver = "auto"; ///< of the heat method
    Progress progress = {};             ///< of the exact method
};

/// Distances of vertices, and the number of values raised to 0.
struct Distance {
    Vector values;
    Index raised;                           ///< 0 for exact distances
    std::vector<std::string> warnings = {}; ///< reasons for large errors
};

/// Distance along a surface, possibly bounded, branching, one-sided, or of several components.
///
/// The exact distance is a property of the shape: it does not depend on the triangulation. The heat
/// method gives a smooth approximation and reuses factorizations: two serve all calls with one
/// source per component; several sources on a component cost two per call. Heat flows for a short
/// time from the sources, which are held at one temperature. The gradient of its logarithm,
/// normalized in every triangle, points towards them. The distance vanishes at the sources, and its
/// gradient is the best fit of the opposite field. On scans and generated surfaces its error
/// averages 1 to 3 % of the greatest distance. The maximum is 2 to 15 %, where shortest paths from
/// several sides meet. Near a boundary corner that is its source, the error is 40 % of the distance
/// there.
class GeodesicDistance {
public:
    /// Takes one length per edge. Throws InvalidInput, naming edge or triangle, unless lengths form
    /// triangles with area; for options of the heat method without it; unless the time scale is
    /// from 1e-6 to 1e6; SolverFailure if the engine cannot factorize.
    GeodesicDistance(const Triangles& surface, const Vector& lengths,
                     const GeodesicOptions& options = {});
    /// On the surface of a discretization, after intrinsic flips on the flipped triangles. Also
    /// throws InvalidInput if it is not a surface.
    GeodesicDistance(const Discretization& discretization, const GeodesicOptions& options = {});

    /// Distance of every vertex from the nearest source, in the unit of the lengths, for a mesh in
    /// the unit of its input. 0 at the sources. With the heat method, triangles far from Delaunay
    /// can cause negative values, which are raised to 0 and counted. Throws InvalidInput for a
    /// source that is not a vertex, and, naming a vertex, if a component has no source or numbers
    /// are out of range; SolverFailure if an engine fails, or if exact distances need too many
    /// windows.
    Distance to(std::span<const Index> sources) const;

private:
    struct Parts;
    Shared<Parts> parts_;
    std::vector<std::string> warnings_; // of the mesh, for the heat method
    std::string advice_;                // on negative duals
    double unit_ = 1;                   // unit of length of the mesh
};

/// The distance, with a solver made for it.
Vector geodesic_distance(const Triangles& surface, const Vector& lengths,
                         std::span<const Index> sources, const GeodesicOptions& options = {});

/// The distance on the surface of a discretization, of the 0-cells of complex() from the given
/// ones. After intrinsic flips it uses the flipped triangles, which make the heat method more
/// accurate if the input's triangles are bad. Also throws InvalidInput if it is not a surface.
Vector geodesic_distance(const Discretization& discretization, std::span<const Index> sources,
                         const GeodesicOptions& options = {});

/// A shortest path as a polyline in space.
struct SurfacePath {
    Index source;  ///< the 0-cell where it ends
    double length; ///< in the unit of the input
    /// Segments in path order, from the vertex to the source. On glued meshes, a path that crosses
    /// a seam resumes at another place.
    Mesh lines;
};

/// Exact distances on the surface of a discretization at every point, and paths and isolines from
/// them. They are computed on the input's triangles, which form the same surface as after intrinsic
/// flips.
class SurfacePaths {
public:
    /// From 0-cells of complex(). Throws InvalidInput if the mesh is not a surface or has lengths
    /// only; for a 0-cell created by splits; and like exact_distance.
    SurfacePaths(const Discretization& mesh, std::span<const Index> sources,
                 const Progress& progress = {});

    /// Throws InvalidInput for a vertex that is not in the input.
    SurfacePath from(Index vertex) const;

    /// Isolines at these distances, as segments. Their ends lie on the isolines up to the square of
    /// the segment length. Each triangle is divided into `divisions` squared ones. Segments share
    /// points within a triangle, not across its sides. `owners` are triangles of the input. Throws
    /// InvalidInput like level_sets, and for divisions below 1.
    LevelSets isolines(const Vector& levels, Index divisions = 8) const;

private:
    struct Parts;
    Shared<Parts> parts_;
};

} // namespace polydec
