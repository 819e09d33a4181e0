// SPDX-License-Identifier: MIT
#pragma once

#include "complex/merging.h"

namespace polydec {

/// The corners of a merged 2-cell in the order its boundary runs, by vertex number, starting with
/// the smallest edge. A cell glued to itself passes some of its corners twice. Any dimension n >=
/// 2; time O(p log p) for p pieces. Throws InvalidInput if there is no such cell.
std::vector<Index> corners(const Merging& merging, Index cell);

/// The same of any 2-cell. Throws InvalidInput too if its boundary is not one simple circle.
std::vector<Index> corners(const CellComplex& complex, Index cell);

} // namespace polydec
