// SPDX-License-Identifier: MIT
#pragma once

#include "dec/merging/merged_cells.h"

namespace polydec {

/// Replaces the pieces of cells that have flat pieces, on which forms have no bound. The new pieces
/// are cones from the mean of a cell's vertices, a new vertex numbered last, over the pieces of its
/// facets. Facets belong to the cells on both sides, so the new pieces fit together where flat ones
/// would leave a crack, whichever cell took these. Independent of numbering, position and scale.
/// For solids, whose points have as many coordinates as the dimension. Throws InvalidInput, naming
/// the cell, unless the whole cell is visible from that mean.
MergedCells cone_flat_cells(const MergedCells& cells);

} // namespace polydec
