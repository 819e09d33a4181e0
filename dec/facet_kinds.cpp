// SPDX-License-Identifier: MIT
#include "dec/facet_kinds.h"

#include "dec/circumsphere.h"
#include "dec/facet_defects.h"
#include "dec/simplex_geometry.h"

namespace polydec {

namespace {

using Row = IncidenceMatrix::InnerIterator;

/// How many of the n-simplices at each facet contain their circumcenter in their interior.
std::vector<Index> well_centered_cofaces(const SimplicialComplex& complex, const Points& points) {
    const int n = complex.dimension();
    std::vector<Index> counts(complex.size(n - 1), 0);
    Circumsphere sphere(points);
    for (Index t = 0; t < complex.size(n); ++t) {
        sphere.look_at(vertices(complex.simplices(n), t));
        bool inside = true;
        for (int i = 0; i <= n; ++i)
            inside = inside && sphere.barycentric(i) > 0;
        for (Row f(complex.coboundary(n - 1), t); inside && f; ++f)
            ++counts[f.col()];
    }
    return counts;
}

} // namespace

FacetKinds facet_kinds(const SimplicialComplex& complex, const Points& points,
                       const CellVolumes& volumes, const MergeOptions& options) {
    const int n = complex.dimension();
    const auto degenerate = facet_defects(complex, points, volumes, options).degenerate;
    const auto well_centered = well_centered_cofaces(complex, points);
    FacetKinds kinds;
    for (Index f = 0; f < complex.size(n - 1); ++f) {
        if (complex.coface_counts(n - 1)[f] != 2)
            continue;
        if (degenerate[f])
            ++kinds.cospherical;
        else if (volumes.dual[n - 1][f] < 0)
            ++kinds.non_delaunay;
        else if (well_centered[f] == 2)
            ++kinds.well_centered;
        else
            ++kinds.delaunay;
    }
    return kinds;
}

} // namespace polydec
