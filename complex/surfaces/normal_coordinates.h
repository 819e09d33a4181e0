// SPDX-License-Identifier: MIT
#pragma once

#include "complex/surfaces/glued_surface.h"

#include <array>
#include <vector>

namespace polydec {

/// How often the edges of one triangulation of a surface, the strands, cross each edge of another
/// one on the same vertices, which flips make of it. Integers alone, so no crossing is ever lost to
/// rounding. Source: Gillespie, Sharp, Crane 2021, Integer coordinates for intrinsic geometry
/// processing.
class NormalCoordinates {
public:
    /// Both triangulations are the same to begin with: every edge is a strand.
    explicit NormalCoordinates(const GluedSurface& surface) : numbers_(surface.edges(), strand) {}

    /// To be told before the surface flips an edge.
    void flip(const GluedSurface& surface, Index edge);

    /// To be told before the surface splits a boundary edge, which must be part of a strand.
    void split_boundary(const GluedSurface& surface, Index edge);

    /// How many strands cross an edge; none where the edge is itself part of one.
    Index crossings(Index edge) const { return numbers_[edge] < 0 ? 0 : numbers_[edge]; }

    /// Whether an edge is part of a strand, or a whole one.
    bool is_strand(Index edge) const { return numbers_[edge] < 0; }

    /// What the strands do at the corners of a triangle.
    struct Corners {
        std::array<Index, 3> cut;     ///< strands that pass from one of its sides to the other
        std::array<Index, 3> leaving; ///< strands that begin there and leave by the opposite side
    };
    Corners corners(const GluedSurface& surface, Index triangle) const;

private:
    static constexpr Index strand = -1;
    std::vector<Index> numbers_;
};

/// All strands that are not edges themselves, each once and as it runs from the smaller of its
/// vertices to the larger.
struct Strands {
    /// A strand leaves a triangle by a half-edge, as the one of this number among all that cross
    /// it, counted from 0 at the half-edge's tail.
    struct Crossing {
        Index halfedge;
        Index position;
    };
    std::vector<std::array<Index, 2>>
        ends;                         ///< of each strand: half-edges whose tails are its ends,
                                      ///< in the first and in the last triangle it passes
    std::vector<Crossing> crossings;  ///< of all strands
    std::vector<std::size_t> offsets; ///< strand s crosses those at offsets[s] and behind
};

/// Follows all strands through the surface. Time of the order of all crossings. Strands whose ends
/// are the same vertex are left out.
Strands trace(const GluedSurface& surface, const NormalCoordinates& coordinates);

} // namespace polydec
