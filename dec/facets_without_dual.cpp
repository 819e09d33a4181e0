// SPDX-License-Identifier: MIT
#include "dec/facets_without_dual.h"

#include "dec/circumsphere.h"

#include <algorithm>
#include <cmath>

namespace polydec {

namespace {

using Row = IncidenceMatrix::InnerIterator;

/// Twice the circumradius of each merged facet: the length its dual is compared with.
Vector facet_scales(const Discretization& discretization) {
    const int n = discretization.dimension();
    if (discretization.intrinsic)
        return discretization.volumes.primal(n - 1); // edges
    const Vector radii = circumradii(discretization.input(), discretization.metric(), n - 1);
    Vector scales = Vector::Zero(discretization.complex().size(n - 1));
    for (Index f = 0; f < scales.size(); ++f)
        for (Row piece(discretization.merging.diamond(n - 1), f); piece; ++piece)
            scales[f] = std::max(scales[f], 2 * radii[piece.col()]);
    return scales;
}

} // namespace

std::vector<bool> boundary_facets_without_dual(const Discretization& discretization) {
    const int n = discretization.dimension();
    const Vector scales = facet_scales(discretization);
    const Vector& dual = discretization.volumes.dual(n - 1);
    std::vector<bool> marks(static_cast<std::size_t>(dual.size()), false);
    for (Index f = 0; f < dual.size(); ++f) // a vertex has no extent to compare with
        marks[f] = discretization.complex().coface_counts(n - 1)[f] == 1 && scales[f] > 0 &&
                   std::abs(dual[f]) <= discretization.options.tolerance * scales[f];
    return marks;
}

} // namespace polydec
