// SPDX-License-Identifier: MIT
#include "dec/merging/facet_kinds.h"

#include "dec/merging/facet_defects.h"
#include "dec/metric/cell_volumes.h"
#include "dec/metric/rounding.h"

namespace polydec {

namespace {

/// How many of the n-simplices at each facet have their circumcenter on their own side of it.
std::vector<Index> centered_cofaces(const Pieces& complex, const SimplexMetric& metric,
                                    const CellVolumes& volumes) {
    std::vector<Index> counts(complex.size(complex.dimension() - 1), 0);
    for_each_height(complex, metric, volumes, [&](Index f, double height, double terms) {
        if (height >= 0 || is_zero(height, terms))
            ++counts[f];
    });
    return counts;
}

} // namespace

FacetKinds facet_kinds(const Pieces& complex, const SimplexMetric& metric,
                       const CellVolumes& volumes, const MergeOptions& options) {
    check_fit(complex, volumes);
    const int n = complex.dimension();
    const auto degenerate = facet_defects(complex, metric, volumes, options).degenerate;
    const auto centered = centered_cofaces(complex, metric, volumes);
    const Vector& dual = volumes.dual(n - 1);
    const Bounds& terms = volumes.terms(n - 1);
    FacetKinds kinds;
    for (Index f = 0; f < complex.size(n - 1); ++f) {
        if (complex.coface_counts(n - 1)[f] != 2)
            continue;
        if (degenerate[f] || is_zero(dual[f], terms[f])) // flat ones have their cell's center
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

MergedPairs merged_pairs(const Merging& merging) {
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
