// SPDX-License-Identifier: MIT
#pragma once

#include "complex/cell_complex.h"

namespace polydec::test {

/// The cells off the boundary: what remains where every form vanishes there.
CellComplex relative_to_boundary(const CellComplex& complex);

} // namespace polydec::test
