// SPDX-License-Identifier: MIT
#pragma once

#include "base/progress.h"
#include "base/shared.h"
#include "complex/surfaces/glued_surface.h"

#include <Eigen/Core>

#include <span>
#include <string_view>
#include <vector>

namespace polydec {

/// Distance of every vertex from the nearest source vertex along a surface of flat triangles with
/// one length per edge: the length of a shortest path, exact up to rounding, in the unit of the
/// lengths. The surface may be bounded, one-sided, branching, of several components and of any
/// genus; edges may be loops. Distances do not depend on the triangulation, so intrinsic flips
/// preserve them.
///
/// Windows run from the sources over the triangles in order of distance. Each is a bundle of
/// straight lines through the same triangles. New windows begin where shortest paths may bend: at
/// vertices with angles above 2 pi or on the boundary. Time and windows grow with the number of
/// triangles to the power 3/2.
/// Source: Mitchell, Mount, Papadimitriou, The discrete geodesic problem, SIAM J. Comput. 16, 1987;
/// Xin, Wang, Improving Chen and Han's algorithm on the discrete geodesic problem, ACM Trans.
/// Graph. 28(4), 2009.
///
/// Throws InvalidInput, naming edge or triangle, unless the lengths form triangles with area;
/// naming the vertex, for a source that is not a vertex, a component without source, and distances
/// that overflow; SolverFailure if there are too many windows, as on needles.
Vector exact_distance(const Triangles& surface, const Vector& lengths,
                      std::span<const Index> sources, const Progress& progress = {});

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
    ShortestPaths(const Triangles& surface, const Vector& lengths, std::span<const Index> sources,
                  const Progress& progress = {});

    /// At the vertices.
    const Vector& distances() const&;
    Vector distances() && { return distances(); }

    /// The distance at a point of a triangle, given by barycentric coordinates with respect to the
    /// tails of its half-edges. Throws InvalidInput unless the triangle exists and, up to rounding,
    /// they are not negative and of sum 1.
    double at(Index triangle, const Eigen::Vector3d& coordinates) const;

    /// The path from a vertex: straight in every triangle and across edges, along edges where it
    /// bends. Empty from a source. Throws InvalidInput if the vertex does not exist.
    ShortestPath from(Index vertex) const;

private:
    struct Parts;
    Shared<Parts> parts_;
};

} // namespace polydec
