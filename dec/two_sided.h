// SPDX-License-Identifier: MIT
#pragma once

#include "dec/forms/cells.h"

namespace polydec {

/// Whether every facet has at most two cofaces, and both agree on its sides: then n-forms are
/// functions, and differ by what flows through the facets.
bool is_two_sided(const CellComplex& complex);

/// Throws InvalidInput, naming a facet with more than two cofaces: dual 0-forms have no difference
/// along its dual.
void check_not_branching(const Cells& cells);

/// Throws InvalidInput, naming a facet, unless the cells are two-sided.
void check_two_sided(const Cells& cells);

} // namespace polydec
