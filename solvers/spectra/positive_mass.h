// SPDX-License-Identifier: MIT
#pragma once

#include "dec/forms/side.h"
#include "dec/metric/cell_volumes.h"

namespace polydec {

/// Throws InvalidInput, naming the cells, if the star of degree k, the mass of forms of that side
/// and degree, is not positive: then they have no norm and their spectrum cannot be counted.
void check_positive_mass(const CellVolumes& volumes, Side side, int degree, int k);

} // namespace polydec
