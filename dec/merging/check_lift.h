// SPDX-License-Identifier: MIT
#pragma once

#include "complex/merging.h"

#include <vector>

namespace polydec {

/// Throws InvalidInput, naming the degree and the shapes, unless there is a matrix for each degree
/// 0..n that takes values on merged cells to values on simplices, as commuting_lift makes them.
void check_lift(const Merging& merging, const std::vector<SparseMatrix>& lift);

} // namespace polydec
