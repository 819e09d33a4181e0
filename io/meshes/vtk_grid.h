// SPDX-License-Identifier: MIT
#pragma once

#include "io/meshes/vtk_cells.h"

#include <array>
#include <cstddef>
#include <vector>

namespace polydec {

/// A grid with cells implied by the numbers of its points along three axes; the first axis varies
/// fastest. Axes with one point do not count, so it may also consist of pixels or edges.
struct VtkGrid {
    std::array<std::size_t, 3> points{1, 1, 1};
    std::array<std::vector<double>, 3> places = {}; ///< along each axis, or empty for all axes
};

/// Throws InvalidInput if the grid has more than 2^31 - 1 points, IoError if memory is
/// insufficient.
void check_grid(const VtkGrid& grid, const Scanner& place);

/// Points at the places along the axes; their numbers must match. Throws like check_grid.
std::vector<double> grid_points(const VtkGrid& grid, const Scanner& place);

/// Appends the cells, as voxels, pixels or lines. Throws like check_grid, and InvalidInput if the
/// grid is a single point.
void add_grid_cells(const VtkGrid& grid, const Scanner& place, VtkArrays& arrays);

} // namespace polydec
