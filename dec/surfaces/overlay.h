// SPDX-License-Identifier: MIT
#pragma once

#include "dec/surfaces/passage.h"

#include <array>

namespace polydec {

/// The input's triangles cut along the edges of the flipped triangles: convex flat pieces, each in
/// one triangle of both. They show on the input what is known on the tessellation.
struct Overlay {
    /// Where an edge of the input is crossed: its ends, and how far from the first, from 0 to 1.
    struct Crossing {
        Index from, to;
        double place;
    };

    Points points; ///< those of the input, then of splits, then where edges of both cross
    std::vector<Crossing> crossings; ///< the last of these points
    std::vector<Index> corners;      ///< of all pieces, one after the other, in cyclic order
    /// Of each of these its barycentric coordinates in the triangle after flips.
    std::vector<std::array<double, 3>> coordinates;
    std::vector<Index> offsets;     ///< piece p has the corners from offsets[p] on
    std::vector<Index> input;       ///< of each piece: the triangle of the input
    std::vector<Index> triangle;    ///< of each piece: the triangle after flips
    std::vector<std::int8_t> signs; ///< 1 where both are oriented alike, else -1
    Vector areas;                   ///< of the pieces, length^2

    /// Rows for vertices, linear along the input's edges, for all points. Throws InvalidInput
    /// unless there is a row for each vertex: of the input and of splits.
    Points at_points(const Points& at_vertices) const;

    Index size() const { return static_cast<Index>(input.size()); }
};

/// Follows every edge of the input over the flipped triangles, by the normal coordinates, and lays
/// the strips of triangles flat to find where it crosses their edges. Pieces without area that
/// rounding leaves are dropped. Time of the order of all crossings, and log(triangles) for each.
/// points are those of the input and behind them those of vertices that splits have made, as
/// Discretization has them. Throws InvalidInput if no edges were flipped, that is, without
/// DiscretizeOptions::delaunay.
Overlay overlay(const Passage& passage, const Points& points);

} // namespace polydec
