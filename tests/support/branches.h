// SPDX-License-Identifier: MIT
#pragma once

#include "complex/cell_complex.h"

#include <algorithm>

namespace polydec::test {

/// Whether three n-cells or more meet at a facet, where dual 0-forms have no differences.
inline bool branches(const CellComplex& complex) {
    const auto& cofaces = complex.coface_counts(complex.dimension() - 1);
    return std::any_of(cofaces.begin(), cofaces.end(), [](Index cells) { return cells > 2; });
}

} // namespace polydec::test
