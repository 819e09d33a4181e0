// SPDX-License-Identifier: MIT
#pragma once

#include "complex/surfaces/glued_surface.h"
#include "complex/surfaces/normal_coordinates.h"
#include "dec/metric/cell_volumes.h"

#include <array>
#include <vector>

namespace polydec {

/// The steps applied to a glued surface, so that cochains can follow: flips, splits of boundary
/// edges, reversed triangles. A flip is a merge followed by a lift: both triangles share the sum of
/// the old values, and the circulation around the quadrilateral, in proportion to area. This fixes
/// the value on the new edge.
class FlipHistory {
public:
    /// The empty history of a surface.
    explicit FlipHistory(const GluedSurface& surface);

    /// Record each step before the surface takes it. A share is the first triangle's fraction of
    /// the area of both, before or after the flip.
    void flip(const GluedSurface& surface, Index edge, double share_before, double share_after);
    /// `fraction`: position of the new vertex, from 0 at the tail of the boundary half-edge to 1.
    void split_boundary(const GluedSurface& surface, Index edge, double fraction);
    void reverse(Index triangle);

    /// For each vertex added by splits, its edge of the first surface: the two ends.
    std::vector<std::array<Index, 2>> edges_of_new_vertices() const;

    /// Maps a primal k-cochain of the first surface to the last. Commutes with d; vertices keep
    /// their values, and new vertices interpolate linearly along their edge. Time of the order of
    /// the steps. Throws InvalidInput, naming both sizes, unless there is one value per k-cell.
    Vector carry(int k, const Vector& values) const;

    /// Maps back from the last surface by the inverse steps. Commutes with d; carry_back after
    /// carry is the identity on vertices and on derivatives of functions.
    Vector carry_back(int k, const Vector& values) const;

    /// The matrix of carry: cells of the last surface times cells of the first. Its rows fill in
    /// where many flips follow each other.
    SparseMatrix matrix(int k) const;

    /// The matrix of carry_back: cells of the first surface times cells of the last.
    SparseMatrix matrix_back(int k) const;

private:
    enum class Kind : std::uint8_t { flip, split, reverse };

    struct Step {
        Kind kind;
        std::int8_t sign;                               // of the edge: i -> j, later k -> l
        Index edge, first, second;                      // triangles; a split makes the second
        std::array<GluedSurface::SignedEdge, 4> around; // jk, ki, il, lj; of a split jk, ki, mj, mk
        std::array<Index, 3> vertices;                  // of a split: i, j, m
        double before, after;                           // shares; of a split the fraction
    };

    template <class Values>
    void take(const Step& step, bool back, int k, Values& values) const;

    std::array<Index, 3> first_sizes_, last_sizes_;
    std::vector<Step> steps_;
};

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
