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
    const Simplices& edges = complex.simplices(1);
    const Vector& lengths = volumes.primal(1);
    for (Index e = 0; e < lengths.size(); ++e)
        for (int i = 0; i <= 1; ++i)
            shortest[edges(e, i)] = std::min(shortest[edges(e, i)], lengths[e]);
    return shortest;
}

std::vector<bool> flat_simplices(const Geometry& geometry) {
    const Pieces& complex = geometry.pieces();
    return can_take_flat_simplices(complex.dimension(), geometry.metric().ambient_dimension())
               ? flat_simplices(geometry, shortest_edges(complex, geometry.volumes()))
               : std::vector<bool>();
}

std::vector<bool> flat_simplices(const Geometry& geometry, const Vector& shortest) {
    constexpr double low = 1e-2; // of an edge
    const Pieces& complex = geometry.pieces();
    const int n = complex.dimension();
    if (!can_take_flat_simplices(n, geometry.metric().ambient_dimension()) || !complex.orientable())
        return {};
    const Simplices& simplices = complex.simplices(n);
    const FaceTable faces = complex.faces(n);
    const Vector &tops = geometry.volumes().primal(n), &facets = geometry.volumes().primal(n - 1);
    std::vector<bool> flat;
    for (Index t = 0; t < tops.size(); ++t) {
        double edge = std::numeric_limits<double>::infinity(), facet = 0;
        for (int i = 0; i <= n; ++i) {
            edge = std::min(edge, shortest[simplices(t, i)]);
            facet = std::max(facet, facets[faces(t, i)]);
        }
        if (n * tops[t] > low * edge * facet)
            continue;
        flat.resize(static_cast<std::size_t>(tops.size()), false);
        flat[t] = true;
    }
    return flat;
}

} // namespace polydec
