// SPDX-License-Identifier: MIT
#pragma once

#include "dec/merging/merged_cells.h"

namespace polydec {

/// Replaces the pieces of cells that have flat ones, whose forms have no bound: by the cones from
/// the mean of a cell's vertices, a new vertex behind the others, over the pieces of its facets.
/// These belong to the cells on both sides, so the new pieces fit together where flat ones would
/// leave a crack, whichever cell took these. Nothing depends on numbers, place or scale.
/// Of solids, whose points have as many coordinates as cells have dimensions. Throws InvalidInput,
/// naming the cell, where not all of a cell is seen from that mean.
MergedCells cone_flat_cells(const MergedCells& cells);

} // namespace polydec
