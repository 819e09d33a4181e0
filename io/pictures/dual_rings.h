// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization/discretization.h"

#include <vector>

namespace polydec {

/// A cell whose center is a corner of a dual cell.
struct DualCorner {
    int degree;
    Index cell;
};

/// The dual cell of a vertex, by the cells whose centers are its corners. On a surface: a polygon
/// for each fan of cells around the vertex, counterclockwise where the cells are; a fan with a rim
/// passes the vertex itself. In a chain of edges: a line from the vertex to the middle of each edge
/// there. Throws InvalidInput, naming the cell, if it passes the vertex twice, and naming the edge,
/// if more than two cells meet there.
std::vector<std::vector<DualCorner>> dual_rings(const Discretization& mesh, Index vertex);

} // namespace polydec
