// SPDX-License-Identifier: MIT
#pragma once

#include "dec/forms/cells.h"

namespace polydec {

/// Whether every facet has at most two cofaces that agree on its sides. Then n-forms are functions,
/// and their differences are fluxes through the facets.
bool is_two_sided(const CellComplex& complex);

/// Throws InvalidInput, naming a facet with more than two cofaces: the difference of a dual 0-form
/// along its dual is undefined.
void check_not_branching(const Cells& cells);

/// Throws InvalidInput, naming a facet, unless the cells are two-sided.
void check_two_sided(const Cells& cells);

} // namespace polydec
