// SPDX-License-Identifier: MIT
#pragma once

#include "base/progress.h"
#include "base/types.h"
#include "shape/geodesics.h"
#include "shape/unfolded_triangles.h"
#include "shape/window_queue.h"

#include <cstddef>
#include <span>
#include <vector>

namespace polydec {

/// The result of window propagation, in the unit of the unfolded triangles.
struct WindowDistances {
    Vector distances;    ///< of vertices; infinite if not reached
    std::size_t windows; ///< number of windows followed
};

/// A window that was followed: what it sees of a side, and the triangle behind the side.
struct PassedWindow {
    Fan fan;
    Index side;   ///< half-edge of the triangle behind
    Index before; ///< the previous window of its lines, or -1 - the corner where they start
};

/// The end of the shortest path to a vertex: at this corner of the triangle that contains its last
/// straight segment. A corner is given by its outgoing half-edge.
struct WindowArrival {
    Index corner = -1; ///< -1: the vertex is a source
    Index before = -1; ///< as in PassedWindow
};

/// All windows, and the arrivals at vertices.
struct WindowTrace {
    std::vector<PassedWindow> windows;
    std::vector<WindowArrival> arrivals;
};

/// The limit on the number of windows: 50 times the need of a surface of well-shaped triangles,
/// which grows with their number to the power 3/2.
std::size_t most_windows(Index triangles);

/// The distance of every vertex from the nearest source, by windows, which are stored in `trace` if
/// given. Throws SolverFailure if there are more than `most` windows; what `progress` throws.
WindowDistances distances_by_windows(const UnfoldedTriangles& surface,
                                     std::span<const Index> sources, std::size_t most,
                                     const Progress& progress = {}, WindowTrace* trace = nullptr);

} // namespace polydec
