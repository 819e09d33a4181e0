// SPDX-License-Identifier: MIT
#pragma once

#include "complex/surfaces/normal_coordinates.h"
#include "dec/metric/cell_volumes.h"
#include "dec/surfaces/flip_history.h"

namespace polydec {

/// Treatment of boundary edges whose dual is not positive; they cannot flip.
enum class BoundaryEdges {
    keep,  ///< their star stays zero or negative
    split, ///< divide them until every star is positive; adds vertices on the boundary only
};

struct IntrinsicDelaunayOptions {
    BoundaryEdges boundary = BoundaryEdges::keep;
    double tolerance = 1e-4; ///< boundary edges with star_1 up to this are split
    Index most = 1000;       ///< flips for each edge, and splits for each on the boundary
};

/// Statistics of the flips and splits of a surface.
struct IntrinsicStatistics {
    Index negative_before = 0; ///< interior edges with a negative star, beyond rounding
    Index flips = 0;
    Index splits = 0;            ///< of boundary edges
    Index negative_interior = 0; ///< remaining; 0
    Index negative_boundary = 0; ///< remaining
    Index negative_boundary_before = 0;
    double added_length = 0; ///< to every edge, if a triangle had almost no area
    double added_area = 0;   ///< relative increase in area by added_length
};

/// A Delaunay triangulation of the same surface: same points, same lengths of all curves. Its edges
/// are geodesics that may cross several triangles of the input.
struct IntrinsicDelaunay {
    GluedSurface surface;
    Vector lengths;              ///< of the edges
    FlipHistory history;         ///< maps forms on the input to forms here, and back
    NormalCoordinates crossings; ///< how the input's edges run on this surface
    IntrinsicStatistics statistics;
};

/// Flips interior edges until no star_1 is negative beyond rounding: 64 eps times the larger of
/// (R/l)^2 and (a^2 + b^2 + c^2) / 4A of the adjacent triangles. Up to ties the result depends only
/// on the surface, and on neither scale nor placement. If a triangle has almost no area, the same
/// small length is added to all edges: the least with which two sides of every triangle together
/// exceed the third by 1e-13 of it, and edges between coinciding points have 1e-5 of the mean
/// length. If boundary edges may be split, they are halved, or divided at a power of two of the
/// mean length from an end whose corner has at most a right angle. Edges are then flipped again,
/// until no boundary star is below the tolerance. Time near-linear in the number of edges, flips
/// and splits. Source: Bobenko, Springborn 2007, A discrete Laplace-Beltrami operator for
/// simplicial surfaces; Fisher, Springborn, Bobenko, Schroeder 2006, An algorithm for the
/// construction of intrinsic Delaunay triangulations. Throws InvalidInput, naming the edge or
/// triangle, for lengths of no triangle. Also throws it, naming the vertex, for splits at a
/// boundary corner whose angle t has tan(t/2) / 2 below the tolerance: one edge there has a smaller
/// star in any triangulation. Throws SolverFailure if flips or splits do not terminate.
IntrinsicDelaunay intrinsic_delaunay(GluedSurface surface, Vector lengths,
                                     const IntrinsicDelaunayOptions& options = {});

} // namespace polydec
