// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"
#include "complex/cell_complex.h"

#include <vector>

namespace polydec {

/// Throws InvalidInput where more of a flux, size(n-1), flows out of a component than in, but for
/// this part of it, and no n-cell of it is tied to a pressure.
void check_balance(const CellComplex& complex, const Vector& flux, const std::vector<bool>& tied,
                   double rounding);

} // namespace polydec
