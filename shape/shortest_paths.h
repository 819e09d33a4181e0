// SPDX-License-Identifier: MIT
#pragma once

#include "complex/surfaces/glued_surface.h"

#include <Eigen/Core>

#include <memory>
#include <span>
#include <vector>

namespace polydec {

/// A point on a side of a triangle; the fraction runs from the tail of the half-edge.
struct SidePoint {
    Index halfedge;
    double fraction;
};

/// A straight piece of a path inside one triangle.
struct PathPiece {
    SidePoint begin, end;
};

/// A shortest path from a vertex to the nearest source.
struct ShortestPath {
    Index source;
    double length; ///< sum of the lengths of the pieces
    std::vector<PathPiece> pieces;
};

/// Exact distances from some vertices along a surface of flat triangles (see exact_distance), at
/// every point, and shortest paths. Keeps all windows: 48 bytes each, some 20 to 200 per triangle.
class ShortestPaths {
public:
    /// Throws like exact_distance.
    ShortestPaths(const Triangles& surface, const Vector& lengths, std::span<const Index> sources);
    ShortestPaths(ShortestPaths&&) noexcept;
    ~ShortestPaths();

    /// At the vertices.
    const Vector& distances() const;

    /// The distance at a point of a triangle, given by barycentric coordinates with respect to the
    /// tails of its half-edges: not negative, of sum 1.
    double at(Index triangle, const Eigen::Vector3d& coordinates) const;

    /// The path from a vertex: straight in every triangle and across edges, along edges where it
    /// bends. Empty from a source. Throws InvalidInput if the vertex does not exist.
    ShortestPath from(Index vertex) const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace polydec
