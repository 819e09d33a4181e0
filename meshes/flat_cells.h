// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <vector>

namespace polydec {

/// How far cells without volume are harmless.
struct FlatCells {
    std::vector<Index> removable; ///< ascending; leaving them out opens no slit
    std::vector<Index> stuck;     ///< ascending; two or more facets belong to other cells
};

/// Finds the cells without volume: n! times the volume at most 1e-12 times the longest edge to the
/// n. Removable are those with at most one facet in another cell, and those that come to be so as
/// others go. Cells are valid and have no repeated corners.
FlatCells find_flat_cells(const Mesh& mesh);

} // namespace polydec
