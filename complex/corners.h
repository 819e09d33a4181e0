// SPDX-License-Identifier: MIT
#pragma once

#include "complex/merging.h"

namespace polydec {

/// The corners of a merged 2-cell in the order its boundary runs, by vertex number, starting with
/// the smallest edge. A cell glued to itself passes some of its corners twice. Any dimension n >=
/// 2; time O(p log p) for p pieces. Throws InvalidInput if there is no such cell.
std::vector<Index> corners(const Merging& merging, Index cell);

/// The same of any 2-cell, without edges that have the cell on both sides. Throws InvalidInput too
/// if the others are not one simple circle: where there are none, or a corner is passed twice.
std::vector<Index> corners(const CellComplex& complex, Index cell);

} // namespace polydec
