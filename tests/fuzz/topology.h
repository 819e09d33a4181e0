// SPDX-License-Identifier: MIT
#pragma once

#include "complex/cell_complex.h"

namespace polydec::fuzz {

/// d d = 0, and the Betti numbers give the Euler characteristic.
void require_topology(const CellComplex& complex);

} // namespace polydec::fuzz
