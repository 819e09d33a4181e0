// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

namespace polydec {

using Edge = std::pair<Index, Index>; ///< the lesser end first

/// The edges of all simplices, ascending, each once.
std::vector<Edge> edges_of(const Simplices& simplices);

/// The vertices of all simplices, ascending, each once.
std::vector<Index> used_vertices(const Simplices& simplices);

/// Throws InvalidInput unless all vertex numbers are 0 to vertices - 1. It names the row, such as
/// "cell 3" for the name "cell", with an addition.
void check_vertices(std::string_view name, const Simplices& rows, Eigen::Index vertices,
                    std::string_view addition = "");

/// Distance between two points, safe against overflow and underflow of squares: 0 for equal points
/// alone. Throws InvalidInput, naming both points, if it is not finite.
double distance(const Points& points, Index a, Index b);

/// The edges from corner 0 of a simplex to its other corners, one a row.
template <class Corners>
DenseMatrix edges_at_first(const Points& points, const Corners& corners) {
    DenseMatrix edges(corners.size() - 1, points.cols());
    for (Index i = 0; i < edges.rows(); ++i)
        edges.row(i) = points.row(corners[i + 1]) - points.row(corners[0]);
    return edges;
}

/// The squared length of the longest edge of a simplex, from these edges.
template <class Edges>
double squared_longest_edge(const Edges& edges) {
    double square = 0;
    for (Index i = 0; i < edges.rows(); ++i) {
        square = std::max(square, edges.row(i).squaredNorm());
        for (Index j = 0; j < i; ++j)
            square = std::max(square, (edges.row(i) - edges.row(j)).squaredNorm());
    }
    return square;
}

} // namespace polydec
