// SPDX-License-Identifier: MIT
#pragma once

#include "complex/surfaces/normal_coordinates.h"
#include "dec/metric/cell_volumes.h"
#include "dec/surfaces/flip_history.h"

namespace polydec {

/// What to do about boundary edges whose dual is not positive: they cannot flip.
enum class BoundaryEdges {
    keep,  ///< their star stays zero or negative
    split, ///< divide them until every star is positive; adds vertices on the boundary alone
};

struct IntrinsicDelaunayOptions {
    BoundaryEdges boundary = BoundaryEdges::keep;
    double tolerance = 1e-4; ///< boundary edges with star_1 up to this are split
    Index most = 1000;       ///< flips for each edge, and splits for each on the boundary
};

/// What flips and splits did to a surface.
struct IntrinsicStatistics {
    Index negative_before = 0; ///< interior edges with a negative star, beyond rounding
    Index flips = 0;
    Index splits = 0;            ///< of boundary edges
    Index negative_interior = 0; ///< that are left; 0
    Index negative_boundary = 0; ///< that are left
    Index negative_boundary_before = 0;
    double added_length = 0; ///< to every edge, where a triangle had nearly no area
    double added_area = 0;   ///< by that, relative
};

/// A Delaunay triangulation of the same surface: same points, same lengths of all curves, but edges
/// are geodesics that may cross several triangles of the input.
struct IntrinsicDelaunay {
    GluedSurface surface;
    Vector lengths;              ///< of the edges
    FlipHistory history;         ///< how forms on the input become forms here, and back
    NormalCoordinates crossings; ///< how the input's edges run here
    IntrinsicStatistics statistics;
};

/// Flips interior edges whose star_1 is negative beyond rounding, 64 eps times the larger of
/// (R/l)^2 and (a^2 + b^2 + c^2) / 4A of the triangles beside it, until there is none; up to ties
/// the result depends on the surface alone. Neither scale nor placement matter. If a triangle has
/// nearly no area, the same small length is added to all edges: the least with which two sides of
/// every triangle are longer than the third by 1e-13 of it, or 1e-5 of the mean
/// length where points coincide. With split boundary, edges there are
/// halved, or divided at a power of two of the mean length from an end whose corner has at most a
/// right angle, and edges flipped again, until no boundary star is below the tolerance. Time
/// near-linear in the number of edges, flips and splits. Source: Bobenko, Springborn 2007, A
/// discrete Laplace-Beltrami operator for simplicial surfaces; Fisher, Springborn, Bobenko,
/// Schroeder 2006, An algorithm for the construction of intrinsic Delaunay triangulations. Throws
/// InvalidInput, naming edge or triangle, for lengths that are no lengths of triangles, and, naming
/// the vertex, for splits at a boundary corner whose angle t has tan(t/2) / 2 below the tolerance:
/// one edge there keeps a smaller star in any triangulation; SolverFailure if flips or splits do
/// not come to an end.
IntrinsicDelaunay intrinsic_delaunay(GluedSurface surface, Vector lengths,
                                     const IntrinsicDelaunayOptions& options = {});

} // namespace polydec
