// SPDX-License-Identifier: MIT
#include "dec/merging/facet_defects.h"
#include "dec/merging/merge.h"
#include "dec/metric/rounding.h"

#include <algorithm>

namespace polydec {

namespace {

/// Number of n-simplices at each facet whose circumcenter is on their own side of it.
std::vector<Index> centered_cofaces(const Geometry& geometry) {
    const Pieces& complex = geometry.pieces();
    std::vector<Index> counts(complex.size(complex.dimension() - 1), 0);
    for_each_height(geometry, [&](Index f, double height, double terms) {
        if (height >= 0 || is_zero(height, terms))
            ++counts[f];
    });
    return counts;
}

} // namespace

FacetKinds facet_kinds(const Geometry& geometry, const MergeOptions& options) {
    const Pieces& complex = geometry.pieces();
    const int n = complex.dimension();
    const auto degenerate = facet_defects(geometry, options).degenerate;
    const auto centered = centered_cofaces(geometry);
    const Vector& dual = geometry.volumes().dual(n - 1);
    const Bounds& terms = geometry.volumes().terms(n - 1);
    FacetKinds kinds;
    for (Index f = 0; f < complex.size(n - 1); ++f) {
        if (complex.coface_counts(n - 1)[f] != 2)
            continue;
        if (degenerate[f] || is_zero(dual[f], terms[f])) // flat ones share their cell's center
            ++kinds.cospherical;
        else if (dual[f] < 0)
            ++kinds.non_delaunay;
        else if (centered[f] == 2)
            ++kinds.well_centered;
        else
            ++kinds.delaunay;
    }
    return kinds;
}

std::optional<LooserTolerance> looser_tolerance(const Geometry& geometry,
                                                const MergeOptions& options) {
    if (options.criterion != MergeCriterion::dual_length)
        return std::nullopt;
    const auto& cofaces = geometry.pieces().coface_counts(geometry.pieces().dimension() - 1);
    const auto many = std::count(cofaces.begin(), cofaces.end(), 2) / 10;
    const auto degenerate = [&](double tolerance) {
        return facet_defects(geometry, {options.criterion, tolerance}).degenerate.interior;
    };
    const Index now = degenerate(options.tolerance);
    std::optional<LooserTolerance> found;
    for (const double factor : {10, 100}) {
        const double tolerance = factor * options.tolerance;
        const Index more = degenerate(tolerance) - now;
        if (more > many && (!found || more > 2 * found->pairs))
            found = {tolerance, more};
    }
    return found;
}

MergedPairs merged_pairs(const Merging& merging) {
    if (merging.is_identity())
        return {};
    const auto& K = merging.pieces();
    const int n = K.dimension();
    const auto& carriers = merging.carriers(n - 1);
    MergedPairs pairs;
    for (const auto& carrier : carriers)
        pairs.facets += carrier.dimension == n ? 1 : 0;
    for (Index t = 0; t < K.size(n); ++t) {
        bool in_pair = false;
        for (int i = 0; i <= n; ++i)
            in_pair = in_pair || carriers[K.face(n, t, i)].dimension == n;
        pairs.simplices += in_pair ? 1 : 0;
    }
    return pairs;
}

} // namespace polydec
