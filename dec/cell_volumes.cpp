// SPDX-License-Identifier: MIT
#include "dec/cell_volumes.h"

#include "base/errors.h"
#include "dec/circumsphere.h"
#include "dec/simplex_geometry.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace polydec {

namespace {

void check_points(const SimplicialComplex& complex, const Points& points) {
    const auto largest = complex.simplices(0).maxCoeff();
    if (largest >= points.rows())
        throw InvalidInput(fmt::format("a cell uses vertex {} but there are only {} points",
                                       largest, points.rows()));
    if (points.cols() < complex.dimension())
        throw InvalidInput(fmt::format("simplices of dimension {} do not fit into {} coordinates",
                                       complex.dimension(), points.cols()));
    for (const Index v : complex.simplices(0).reshaped())
        if (!points.row(v).allFinite())
            throw InvalidInput(fmt::format("vertex {} has a coordinate that is not finite", v));
}

/// Products of a few volumes must neither overflow nor vanish.
void check_size(const SimplicialComplex& complex, int k, Index s, double volume) {
    constexpr double largest = 1e100;
    if (volume < largest && volume > 1 / largest)
        return;
    throw InvalidInput(fmt::format(
        "the {}-simplex with vertices {} has volume {:.3g}: scale the mesh to a size nearer to 1",
        k, fmt::join(vertices(complex.simplices(k), s), ", "), volume));
}

} // namespace

CellVolumes circumcentric_volumes(const SimplicialComplex& complex, const Points& points) {
    check_points(complex, points);
    const int n = complex.dimension();
    CellVolumes volumes;
    for (int k = 0; k <= n; ++k) {
        volumes.primal.emplace_back(Vector::Ones(complex.size(k)));
        volumes.dual.emplace_back(Vector::Zero(complex.size(k)));
    }
    volumes.dual[n].setOnes();

    Circumsphere sphere(points);
    for (int k = 1; k <= n; ++k)
        for (Index s = 0; s < complex.size(k); ++s) {
            if (!sphere.look_at(vertices(complex.simplices(k), s)))
                throw InvalidInput(fmt::format(
                    "the {}-simplex with vertices {} has no volume: remove it or move a vertex", k,
                    fmt::join(vertices(complex.simplices(k), s), ", ")));
            check_size(complex, k, s, sphere.volume());
            volumes.primal[k][s] = sphere.volume();
        }
    for (int k = n - 1; k >= 0; --k) {
        for (Index t = 0; t < complex.size(k + 1); ++t) {
            sphere.look_at(vertices(complex.simplices(k + 1), t));
            for (int i = 0; i <= k + 1; ++i) {
                const Index s = complex.face(k + 1, t, i);
                volumes.dual[k][s] +=
                    sphere.height(i, volumes.primal[k][s]) * volumes.dual[k + 1][t];
            }
        }
        volumes.dual[k] /= n - k;
    }
    return volumes;
}

CellVolumes merged_volumes(const Merging& merging, const CellVolumes& input) {
    CellVolumes volumes;
    for (int k = 0; k <= merging.merged().dimension(); ++k) {
        const SparseMatrix pieces = merging.diamond(k).cast<double>().cwiseAbs();
        volumes.primal.emplace_back(pieces * input.primal[k]);
        const Vector products = pieces * input.primal[k].cwiseProduct(input.dual[k]);
        volumes.dual.emplace_back(products.cwiseQuotient(volumes.primal[k]));
    }
    return volumes;
}

} // namespace polydec
