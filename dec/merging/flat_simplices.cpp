// SPDX-License-Identifier: MIT
#include "dec/merging/flat_simplices.h"

#include <algorithm>
#include <limits>

namespace polydec {

bool can_take_flat_simplices(int dimension, Index ambient_dimension) {
    constexpr int solid = 3;
    return dimension == solid && ambient_dimension == solid;
}

Vector shortest_edges(const Pieces& complex, const CellVolumes& volumes) {
    Vector shortest = Vector::Constant(complex.size(0), std::numeric_limits<double>::infinity());
    for (Index e = 0; e < complex.size(1); ++e)
        for (const Index v : complex.simplices(1).row(e))
            shortest[v] = std::min(shortest[v], volumes.primal(1)[e]);
    return shortest;
}

std::vector<bool> flat_simplices(const Pieces& complex, const SimplexMetric& metric,
                                 const CellVolumes& volumes) {
    constexpr double low = 1e-2; // of an edge
    const int n = complex.dimension();
    if (!can_take_flat_simplices(n, metric.ambient_dimension()) || !complex.orientable())
        return {};
    const Vector shortest = shortest_edges(complex, volumes);
    std::vector<bool> flat;
    for (Index t = 0; t < complex.size(n); ++t) {
        double edge = std::numeric_limits<double>::infinity(), facet = 0;
        for (int i = 0; i <= n; ++i) {
            edge = std::min(edge, shortest[complex.simplices(n)(t, i)]);
            facet = std::max(facet, volumes.primal(n - 1)[complex.face(n, t, i)]);
        }
        if (n * volumes.primal(n)[t] > low * edge * facet)
            continue;
        flat.resize(static_cast<std::size_t>(complex.size(n)), false);
        flat[t] = true;
    }
    return flat;
}

} // namespace polydec
