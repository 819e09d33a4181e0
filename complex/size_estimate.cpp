// SPDX-License-Identifier: MIT
#include "complex/size_estimate.h"

#include <algorithm>
#include <cmath>

namespace polydec {

namespace {

double binomial(double n, double k) {
    return std::round(std::exp(std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1)));
}

} // namespace

double SizeEstimate::bytes() const {
    // measured on grids of dimension 2 to 5 and on single simplices up to dimension 20
    constexpr double for_each_cell = 85, for_each_incidence = 28;
    return for_each_cell * cells + for_each_incidence * incidences;
}

SizeEstimate estimate_size(int dimension, Index simplices, Index vertices) {
    const double n = dimension, tops = simplices;
    // of all k-faces of the n-simplices one by one, the fraction that are different
    const double of_vertices = std::min(1.0, vertices / (tops * (n + 1)));
    const double of_facets = std::max(0.5, std::pow(of_vertices, 1 / n));
    SizeEstimate size{tops, tops * (n + 1)};
    for (int k = dimension - 1; k >= 0; --k) {
        const double steps = n > 1 ? (n - 1 - k) / (n - 1) : 1;
        const double fraction = of_facets * std::pow(of_vertices / of_facets, steps);
        const double cells = tops * binomial(n + 1, k + 1.0) * fraction;
        size.cells += cells;
        size.incidences += k > 0 ? cells * (k + 1.0) : 0;
    }
    return size;
}

} // namespace polydec
