// SPDX-License-Identifier: MIT
#pragma once

#include "complex/surfaces/glued_surface.h"

#include <array>
#include <vector>

namespace polydec {

/// For each edge of a triangulation made by flips, the number of its crossings with the strands,
/// the edges of the original triangulation of the same vertices. Only integers, so rounding never
/// loses a crossing. Source: Gillespie, Sharp, Crane 2021, Integer coordinates for intrinsic
/// geometry processing.
class NormalCoordinates {
public:
    /// Initially both triangulations are the same: every edge is a strand.
    explicit NormalCoordinates(const GluedSurface& surface) : numbers_(surface.edges(), strand) {}

    /// Call before the surface flips an edge.
    void flip(const GluedSurface& surface, Index edge);

    /// Call before the surface splits a boundary edge, which must be part of a strand.
    void split_boundary(const GluedSurface& surface, Index edge);

    /// Number of strands that cross an edge; 0 if the edge is itself part of a strand.
    Index crossings(Index edge) const { return numbers_[edge] < 0 ? 0 : numbers_[edge]; }

    /// Whether an edge is a strand or part of one.
    bool is_strand(Index edge) const { return numbers_[edge] < 0; }

    /// The strands at the corners of a triangle.
    struct Corners {
        std::array<Index, 3> cut;     ///< strands that pass from one adjacent side to the other
        std::array<Index, 3> leaving; ///< strands that begin there and leave by the opposite side
    };
    Corners corners(const GluedSurface& surface, Index triangle) const;

private:
    static constexpr Index strand = -1;
    std::vector<Index> numbers_;
};

/// All strands that are not edges themselves, each once and from its smaller vertex to the larger.
struct Strands {
    /// Where a strand leaves a triangle: the half-edge, and the strand's position among all strands
    /// that cross it, counted from 0 at the half-edge's tail.
    struct Crossing {
        Index halfedge;
        Index position;
    };
    std::vector<std::array<Index, 2>>
        ends;                         ///< of each strand: half-edges whose tails are its ends,
                                      ///< in the first and in the last triangle it passes
    std::vector<Crossing> crossings;  ///< of all strands
    std::vector<std::size_t> offsets; ///< strand s has the crossings from offsets[s] on
};

/// Follows all strands through the surface. Time of the order of all crossings. Leaves out strands
/// whose ends are the same vertex.
Strands trace(const GluedSurface& surface, const NormalCoordinates& coordinates);

} // namespace polydec
