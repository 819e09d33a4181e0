// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"
#include "shape/unfolded_triangles.h"

#include <cstddef>
#include <span>
#include <vector>

namespace polydec {

/// What windows found, in units of the lengths of the unfolded triangles.
struct WindowDistances {
    Vector distances;    ///< of vertices; infinite where none came
    std::size_t windows; ///< how many were followed
};

/// A window that was followed: from (along, -below), `offset` away from the source, it sees the
/// part from `begin` to `end` of a side, and the triangle behind that. See Window.
struct PassedWindow {
    double begin, end, along, below, offset;
    Index side;
    Index before; ///< the window that its lines passed before, or -1 - the corner they start from
};

/// How the shortest path found to a vertex ends: at this corner, of a triangle that its last
/// straight line is in. A corner is the half-edge that begins there.
struct WindowArrival {
    Index corner = -1; ///< -1: the vertex is a source
    Index before = -1; ///< as of a window
};

/// All windows, and the arrivals at vertices.
struct WindowTrace {
    std::vector<PassedWindow> windows;
    std::vector<WindowArrival> arrivals;
};

/// The windows that are followed at most: 50 times what a surface of well-shaped triangles needs,
/// which grows with their number to the power 3/2.
std::size_t most_windows(Index triangles);

/// The distance of every vertex from the nearest of the sources, by windows.
/// Keeps them in a trace that is given. Throws SolverFailure if it takes more than `most` of them.
WindowDistances distances_by_windows(const UnfoldedTriangles& surface,
                                     std::span<const Index> sources, std::size_t most,
                                     WindowTrace* trace = nullptr);

} // namespace polydec
