// SPDX-License-Identifier: MIT
#include "dec/facets_without_dual.h"

#include "dec/forms/star.h"
#include "dec/merging/facet_defects.h"

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
    const auto pieces = facet_defects(
        discretization.pieces(), discretization.metric(), discretization.piece_volumes(),
        {MergeCriterion::dual_length, discretization.options().tolerance});
    for (Index f = 0; f < complex.size(n - 1); ++f) {
        if (counts[f] != 1)
            continue;
        double scale = 0, height = std::numeric_limits<double>::infinity();
        for (Row piece(facets, f); piece; ++piece) {
            scale = std::max(scale, pieces.scale[piece.col()]);
            height = std::min(height, pieces.height[piece.col()]);
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
