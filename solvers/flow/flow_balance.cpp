// SPDX-License-Identifier: MIT
#include "solvers/flow/flow_balance.h"

#include "base/errors.h"
#include "complex/components.h"
#include "dec/forms/derivative.h"

#include <fmt/format.h>

#include <cmath>

namespace polydec {

void check_balance(const CellComplex& complex, const Vector& flux, const std::vector<bool>& tied,
                   double rounding) {
    const int n = complex.dimension();
    const Components parts = components(complex);
    Vector sums = Vector::Zero(parts.count), sizes = sums;
    std::vector<bool> open(static_cast<std::size_t>(parts.count), false);
    const Vector excess = derivative(complex, n - 1) * flux;
    const Vector through = derivative(complex, n - 1).cwiseAbs() * flux.cwiseAbs();
    for (Index cell = 0; cell < excess.size(); ++cell) {
        Index corner = cell;
        for (int k = n; k > 0; --k)
            corner = complex.incidences(k - 1)[corner][0].face;
        const Index part = parts.of_vertex[corner];
        sums[part] += excess[cell];
        sizes[part] += through[cell];
        open[part] = open[part] || tied[cell];
    }
    for (Index part = 0; part < parts.count; ++part)
        if (!open[part] && std::abs(sums[part]) > rounding * sizes[part])
            throw InvalidInput(fmt::format("through the boundary {:.6g} more flows out than in, of "
                                           "{:.6g}: expected a balance, or an open boundary",
                                           sums[part], sizes[part]));
}

} // namespace polydec
