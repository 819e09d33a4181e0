// SPDX-License-Identifier: MIT
#pragma once

#include "backends/mesher.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace polydec {

/// Holds what a mesher made against what it was given, and takes over the coordinates of the input.
/// Every tetrahedron has a positive volume, by an exact sign, and each face is in two of them, one
/// on each side, or on the boundary. Without facets the boundary is convex. With facets: the faces
/// that are said to make them up close as they do, lie in their planes and have their areas; there
/// are tetrahedra inside of each, up to the next one, unless a hole is there; the boundary consists
/// of such faces, and volumes add up to what the surfaces enclose.
/// Throws SolverFailure, naming the engine and what is not so. The input must be a checked one.
void check_mesher_output(const MesherInput& input, const std::string& engine, MesherOutput& output);

/// A face of a tetrahedron: ascending corners, and whether its boundary, seen from outside of that
/// tetrahedron, runs around it in this order.
struct OutwardFace {
    std::array<Index, 3> corners;
    Index cell;
    bool is_ascending;
};

/// Sorts the corners, with the sense in which they are meant kept.
void sort_corners(OutwardFace& face);

/// How many of the sorted faces are in one tetrahedron.
std::size_t boundary_size(const std::vector<OutwardFace>& faces);

/// What is checked, with coordinates near 1, by a power of two.
struct MesherResult {
    const MesherInput& input; ///< its points and holes are scaled too
    const MesherOutput& output;
    const std::string& engine;
    int exponent;                   ///< of that power
    std::vector<Index> used;        ///< the points of the input that the first points are
    std::vector<OutwardFace> faces; ///< of all tetrahedra, by corners
    double volume;                  ///< of all tetrahedra

    [[noreturn]] void fail(const std::string& what) const;
    std::string cell_name(Index cell) const;
};

/// The part of check_mesher_output that is about facets.
void check_facets_filled(const MesherResult& result);

} // namespace polydec
