// SPDX-License-Identifier: MIT
#pragma once

#include "complex/sides.h"
#include "tests/support/test.h"

namespace polydec::test {

/// The facets that merging by label removes: two cofaces, both with the same label. `labels` has
/// one entry per n-simplex.
inline std::vector<bool> facets_within_labels(const Pieces& complex,
                                              const std::vector<Index>& labels) {
    const Sides sides(complex);
    std::vector<bool> removed;
    for (Index f = 0; f < complex.size(complex.dimension() - 1); ++f)
        removed.push_back(sides.exist(f) && labels[sides.first(f)] == labels[sides.second(f)]);
    return removed;
}

} // namespace polydec::test
