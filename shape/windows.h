// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"
#include "shape/unfolded_triangles.h"

#include <cstddef>
#include <span>

namespace polydec {

/// What windows found, in units of the lengths of the unfolded triangles.
struct WindowDistances {
    Vector distances;    ///< of vertices; infinite where none came
    std::size_t windows; ///< how many were followed
};

/// The windows that are followed at most: 50 times what a surface of well-shaped triangles needs,
/// which grows with their number to the power 3/2.
std::size_t most_windows(Index triangles);

/// The distance of every vertex from the nearest of the sources, by windows.
/// Throws SolverFailure if it takes more than `most` of them.
WindowDistances distances_by_windows(const UnfoldedTriangles& surface,
                                     std::span<const Index> sources, std::size_t most);

} // namespace polydec
