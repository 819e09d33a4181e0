// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <vector>

namespace polydec {

/// Cells without volume, by whether their removal is harmless.
struct FlatCells {
    std::vector<Index> removable; ///< ascending; removing them opens no slit
    std::vector<Index> stuck;     ///< ascending; two or more facets belong to other cells
};

/// The cells without volume, ascending: n! times the volume is at most 1e-12 times the longest edge
/// to the n. Vertex numbers are valid.
std::vector<Index> flat_cells(const Mesh& mesh);

/// Sorts them. A cell is removable if at most one facet belongs to another cell, counting only
/// cells that stay. Cells are valid and have no repeated corners.
FlatCells find_flat_cells(const Mesh& mesh);

} // namespace polydec
