// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "meshes/level_sets.h"

#include <memory>
#include <span>

namespace polydec {

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
    SurfacePaths(const Discretization& mesh, std::span<const Index> sources);
    SurfacePaths(SurfacePaths&&) noexcept;
    ~SurfacePaths();

    /// Throws InvalidInput for a vertex that is not in the input.
    SurfacePath from(Index vertex) const;

    /// Isolines at these distances, as segments. Their ends lie on the isolines up to the square of
    /// the segment length. Each triangle is divided into `divisions` squared ones. `owners` are
    /// triangles of the input. Throws InvalidInput like level_sets, and for divisions below 1.
    LevelSets isolines(const Vector& levels, Index divisions = 8) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace polydec
