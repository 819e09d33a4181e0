// SPDX-License-Identifier: MIT
#include "tests/support/relative.h"

#include "complex/components.h"

#include <utility>

namespace polydec::test {

CellComplex relative_to_boundary(const CellComplex& complex) {
    const auto marks = boundary_cells(complex);
    std::vector<std::vector<Index>> number;
    std::vector<Index> sizes;
    for (int k = 0; k <= complex.dimension(); ++k) {
        number.emplace_back(complex.size(k), -1);
        sizes.push_back(0);
        for (Index s = 0; s < complex.size(k); ++s)
            if (!marks[k][s])
                number[k][s] = sizes[k]++;
    }
    std::vector<IncidenceMatrix> d;
    for (int k = 0; k < complex.dimension(); ++k) {
        std::vector<Eigen::Triplet<std::int8_t, Index>> entries;
        for (Index t = 0; t < complex.size(k + 1); ++t)
            for (IncidenceMatrix::InnerIterator s(complex.coboundary(k), t); s; ++s)
                if (number[k][s.col()] >= 0 && number[k + 1][t] >= 0)
                    entries.emplace_back(number[k + 1][t], number[k][s.col()], s.value());
        d.emplace_back(sizes[k + 1], sizes[k]).setFromTriplets(entries.begin(), entries.end());
    }
    return CellComplex(std::move(d));
}

} // namespace polydec::test
