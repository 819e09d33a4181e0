// SPDX-License-Identifier: MIT
#pragma once

#include "io/pages/page.h"

#include <filesystem>

namespace polydec {

/// The cells and all arrays of a .vtu file, unchanged; arrays of 4 to 9 components are split into
/// single components. Voxels, wedges and pyramids become polyhedra; other VTK types that VtuGrid
/// lacks are errors. Reads what read_mesh reads of such files, and polyhedra. A .pvtu file is the
/// .vtu files of its pieces, one after the other. Throws InvalidInput, naming the file; IoError if
/// it cannot be read.
VtuGrid read_grid(const std::filesystem::path& path);

/// The grids of a .pvd file, which lists .vtu files with times: cells and points of the first one,
/// and a step for each. Throws like read_grid, and if the files have different arrays, or more than
/// one part.
Page read_series(const std::filesystem::path& path);

} // namespace polydec
