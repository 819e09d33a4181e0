// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"

namespace polydec {

/// What each vertex gets of the areas of the (n-1)-cells: each piece is shared among its vertices
/// as their duals divide it, equally for finite elements. size(0) x size(n-1).
SparseMatrix shares_of_vertices(const Discretization& mesh);

/// The same where nothing is known of duals: equal shares.
SparseMatrix shares_of_vertices(const CellComplex& complex, const HodgeStars& stars);

} // namespace polydec
