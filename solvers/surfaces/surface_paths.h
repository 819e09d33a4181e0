// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "meshes/level_sets.h"

#include <memory>
#include <span>

namespace polydec {

/// A shortest path as it lies in space.
struct SurfacePath {
    Index source;  ///< the 0-cell that it leads to
    double length; ///< in the unit of the input
    /// Segments in the order of the path, from the vertex to the source. On glued meshes, where a
    /// path crosses a seam, the next begins at another place.
    Mesh lines;
};

/// Exact distances on the surface of a bundle as the windows know them, at every point and not at
/// vertices alone: paths and isolines. They are found on the input's triangles, which is the same
/// surface as after intrinsic flips.
class SurfacePaths {
public:
    /// From 0-cells of complex(). Throws InvalidInput if the mesh is no surface, or only its
    /// lengths are known, for a 0-cell that splits have made, and like exact_distance.
    SurfacePaths(const Discretization& mesh, std::span<const Index> sources);
    SurfacePaths(SurfacePaths&&) noexcept;
    ~SurfacePaths();

    /// Throws InvalidInput for a vertex that is none of the input's.
    SurfacePath from(Index vertex) const;

    /// Points at these distances, as segments: their ends lie on the lines up to the square of the
    /// length of a segment, in triangles that are divided into `divisions` squared ones.
    /// `owners` are triangles of the input. Throws InvalidInput like level_sets, and for
    /// divisions below 1.
    LevelSets isolines(const Vector& levels, Index divisions = 8) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace polydec
