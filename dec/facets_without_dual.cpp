// SPDX-License-Identifier: MIT
#include "dec/facets_without_dual.h"

namespace polydec {

std::vector<bool> boundary_facets_without_dual(const CellComplex& complex,
                                               const HodgeStars& stars) {
    check_fit(complex, stars);
    const int n = complex.dimension();
    std::vector<bool> marks(static_cast<std::size_t>(complex.size(n - 1)), false);
    for (const Index f : stars[n - 1].zeros())
        marks[f] = complex.coface_counts(n - 1)[f] == 1;
    return marks;
}

} // namespace polydec
