// SPDX-License-Identifier: MIT
#pragma once

#include "io/meshes/vtk_cells.h"

#include <array>
#include <cstddef>
#include <vector>

namespace polydec {

/// A grid whose cells follow from the numbers of its points along three axes; the first axis goes
/// fastest. Axes with one point are none, so that it may also be of pixels or edges.
struct VtkGrid {
    std::array<std::size_t, 3> points{1, 1, 1};
    std::array<std::vector<double>, 3> places = {}; ///< along each axis, or none of all
};

/// Throws InvalidInput if the grid has more than 2^31 - 1 points, IoError if memory does not
/// suffice.
void check_grid(const VtkGrid& grid, const Scanner& place);

/// Points at the places along the axes, which are as many as promised. Throws like check_grid.
std::vector<double> grid_points(const VtkGrid& grid, const Scanner& place);

/// Appends the cells, as voxels, pixels or lines. Throws like check_grid, and InvalidInput if the
/// grid is a single point.
void add_grid_cells(const VtkGrid& grid, const Scanner& place, VtkArrays& arrays);

} // namespace polydec
