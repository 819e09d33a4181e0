// SPDX-License-Identifier: MIT
#pragma once

#include "dec/surfaces/passage.h"

#include <array>

namespace polydec {

/// The input's triangles cut along the edges of the flipped triangles: convex flat pieces, each in
/// one triangle of both. They show results of the flipped triangulation on the input.
struct Overlay {
    /// Crossing on an edge of the input: its ends, and the position from the first end, from 0 to
    /// 1.
    struct Crossing {
        Index from, to;
        double place;
    };

    Points points; ///< of the input, then of splits, then crossings of the edges of both
    std::vector<Crossing> crossings; ///< one for each of the last points
    std::vector<Index> corners;      ///< of all pieces, concatenated, each in cyclic order
    /// For each corner its barycentric coordinates in the triangle after flips.
    std::vector<std::array<double, 3>> coordinates;
    std::vector<Index> offsets;     ///< piece p has the corners from offsets[p] on
    std::vector<Index> input;       ///< for each piece: the triangle of the input
    std::vector<Index> triangle;    ///< for each piece: the triangle after flips
    std::vector<std::int8_t> signs; ///< 1 if both are oriented alike, else -1
    Vector areas;                   ///< of the pieces, length^2

    /// Interpolates rows at vertices linearly along the input's edges, for all points. Throws
    /// InvalidInput unless there is one row per vertex of the input and of splits.
    Points at_points(const Points& at_vertices) const;

    Index size() const { return static_cast<Index>(input.size()); }
};

/// Follows every edge of the input across the flipped triangles by the normal coordinates, and lays
/// the strips of triangles flat to locate the crossings. Drops pieces whose area is zero up to
/// rounding. Time of the order of all crossings, and log(triangles) for each. `points`: the points
/// of the input, then of the vertices added by splits, as in Discretization. Throws InvalidInput if
/// no edges were flipped, that is, without DiscretizeOptions::delaunay.
Overlay overlay(const Passage& passage, const Points& points);

} // namespace polydec
