// SPDX-License-Identifier: MIT
#pragma once

#include "complex/merging.h"

namespace polydec {

/// The corners of a merged 2-cell in the order of its boundary, as vertex numbers, starting with
/// the smallest edge. A cell glued to itself passes some corners twice. Any dimension n >= 2; time
/// O(p log p) for p pieces. Throws InvalidInput if there is no such cell.
std::vector<Index> corners(const Merging& merging, Index cell);

/// The same for any 2-cell, ignoring edges with the cell on both sides. Also throws InvalidInput
/// unless the other edges form one simple circle: if there are none, or a corner is passed twice.
std::vector<Index> corners(const CellComplex& complex, Index cell);

} // namespace polydec
