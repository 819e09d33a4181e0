// SPDX-License-Identifier: MIT
#include "dec/metric/dual_parts.h"

#include "base/checks.h"
#include "dec/metric/cell_volumes.h"
#include "dec/metric/circumsphere.h"

namespace polydec {

namespace {

/// Entry (t, s): the signed distance between the circumcenters of k-simplex s and its coface t.
SparseMatrix heights(const SimplicialComplex& complex, const SimplexMetric& metric,
                     const CellVolumes& volumes, int k) {
    SparseMatrix H = complex.coboundary(k).cast<double>();
    SimplexLayout layout(complex, metric);
    Circumsphere sphere;
    for (Index t = 0; t < complex.size(k + 1); ++t) {
        sphere.look_at(layout, k + 1, t);
        // faces stand in the row in the order of their numbers, which omits the last vertex first
        for (int i = 0; i <= k + 1; ++i) {
            const Index entry = t * (k + 2) + (k + 1 - i);
            H.valuePtr()[entry] = sphere.height(i, volumes.primal(k)[H.innerIndexPtr()[entry]]);
        }
    }
    return H;
}

} // namespace

SparseMatrix dual_parts(const SimplicialComplex& complex, const SimplexMetric& metric,
                        const CellVolumes& volumes, int k, int m) {
    check_number("parts of duals in simplices of degree", m, 0, complex.dimension());
    check_number("parts of the duals of simplices of degree", k, 0, m);
    check_fit(complex, volumes);
    SparseMatrix parts(complex.size(m), complex.size(m));
    parts.setIdentity();
    for (int j = m - 1; j >= k; --j) {
        const SparseMatrix next = parts * heights(complex, metric, volumes, j);
        parts = next / (m - j);
    }
    return parts;
}

} // namespace polydec
