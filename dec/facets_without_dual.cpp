// SPDX-License-Identifier: MIT
#include "dec/facets_without_dual.h"

#include "dec/forms/star.h"
#include "dec/merging/facet_defects.h"
#include "dec/merging/flat_simplices.h"
#include "dec/metric/circumsphere.h"

#include <algorithm>
#include <limits>

namespace polydec {

namespace {

using Row = IncidenceMatrix::InnerIterator;

} // namespace

std::vector<bool> boundary_facets_without_dual(const Discretization& discretization) {
    const auto& complex = discretization.complex();
    if (discretization.chosen_stars().kind != StarKind::circumcentric)
        return boundary_facets_without_dual(complex, discretization.stars());
    const int n = discretization.dimension();
    const auto& volumes = discretization.volumes();
    const auto& counts = complex.coface_counts(n - 1);
    std::vector<bool> marks(counts.size(), false);
    if (std::find(counts.begin(), counts.end(), 1) == counts.end())
        return marks;
    const auto& facets = discretization.merging().diamond(n - 1);
    // what the duals of the pieces are compared with
    const auto& pieces = discretization.pieces();
    const auto& of_pieces = discretization.piece_volumes();
    const Vector scales = 2 * circumradii(pieces, discretization.metric(), n - 1);
    const Vector heights = least_heights(
        pieces, of_pieces, flat_simplices(pieces, discretization.metric(), of_pieces));
    for (Index f = 0; f < complex.size(n - 1); ++f) {
        if (counts[f] != 1)
            continue;
        double scale = 0, height = std::numeric_limits<double>::infinity();
        for (Row piece(facets, f); piece; ++piece) {
            scale = std::max(scale, scales[piece.col()]);
            height = std::min(height, heights[piece.col()]);
        }
        marks[f] = is_degenerate(volumes.dual(n - 1)[f], volumes.terms(n - 1)[f], scale, height,
                                 discretization.options().tolerance);
    }
    return marks;
}

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
