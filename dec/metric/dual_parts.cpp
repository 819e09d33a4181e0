// SPDX-License-Identifier: MIT
#include "dec/metric/dual_parts.h"

#include "base/checks.h"
#include "dec/metric/cell_volumes.h"
#include "dec/metric/circumsphere.h"

#include <utility>
#include <vector>

namespace polydec {

namespace {

/// Entry (t, s): the signed distance between the circumcenters of k-simplex s and its coface t;
/// their sum where s is a face of t twice.
SparseMatrix heights(const Pieces& complex, const SimplexMetric& metric, const CellVolumes& volumes,
                     int k) {
    std::vector<Eigen::Triplet<double, Index>> entries;
    entries.reserve(static_cast<std::size_t>(complex.size(k + 1)) * (k + 2));
    SimplexLayout layout(complex, metric);
    Circumsphere sphere;
    for (Index t = 0; t < complex.size(k + 1); ++t) {
        sphere.look_at(layout, k + 1, t);
        for (int i = 0; i <= k + 1; ++i) {
            const Index face = complex.face(k + 1, t, i);
            entries.emplace_back(t, face, sphere.height(i, volumes.primal(k)[face]));
        }
    }
    SparseMatrix H(complex.size(k + 1), complex.size(k));
    H.setFromTriplets(entries.begin(), entries.end()); // a face met twice has both heights
    return H;
}

} // namespace

SparseMatrix dual_parts(const Pieces& complex, const SimplexMetric& metric,
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

DenseMatrix corner_parts(const Pieces& complex, const SimplexMetric& metric,
                         const CellVolumes& volumes, int m) {
    check_number("parts of duals in simplices of degree", m, 0, complex.dimension());
    check_fit(complex, volumes);
    DenseMatrix parts = DenseMatrix::Ones(complex.size(0), 1);
    SimplexLayout layout(complex, metric);
    Circumsphere sphere;
    for (int k = 1; k <= m; ++k) {
        DenseMatrix next = DenseMatrix::Zero(complex.size(k), k + 1);
        for (Index t = 0; t < complex.size(k); ++t) {
            sphere.look_at(layout, k, t);
            for (int omitted = 0; omitted <= k; ++omitted) {
                const Index face = complex.face(k, t, omitted);
                const double height = sphere.height(omitted, volumes.primal(k - 1)[face]) / k;
                for (int i = 0; i < k; ++i)
                    next(t, i < omitted ? i : i + 1) += height * parts(face, i);
            }
        }
        parts = std::move(next);
    }
    return parts;
}

} // namespace polydec
