// SPDX-License-Identifier: MIT
#include "dec/cell_volumes.h"

#include "base/errors.h"
#include "base/parallel.h"
#include "dec/circumsphere.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

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

void check_metric(const SimplicialComplex& complex, const SimplexMetric& metric) {
    if (metric.points() != nullptr)
        check_points(complex, *metric.points());
    else if (metric.lengths()->size() != complex.size(1))
        throw InvalidInput(fmt::format("a metric of {} lengths is given: expected one for each of "
                                       "the {} edges of the complex",
                                       metric.lengths()->size(), complex.size(1)));
}

/// Products of a few volumes must neither overflow nor vanish.
bool is_moderate(double volume) {
    constexpr double largest = 1e100;
    return volume < largest && volume > 1 / largest;
}

/// Names the simplex of least dimension, of those with t, whose volume is of no use.
[[noreturn]] void refuse(const SimplicialComplex& complex, const SimplexMetric& metric, int k,
                         Index t) {
    SimplexLayout layout(complex, metric);
    Circumsphere sphere;
    for (int m = 1; m < k; ++m)
        for (Index s = 0; s < complex.size(m); ++s) {
            sphere.look_at(layout.at(m, s));
            if (!is_moderate(sphere.volume()))
                refuse(complex, metric, m, s);
        }
    const auto list = vertices(complex.simplices(k), t);
    sphere.look_at(layout.at(k, t));
    if (sphere.volume() == 0 && metric.lengths() != nullptr)
        throw InvalidInput(flaw_of_lengths(complex, metric, k, t));
    if (sphere.volume() == 0)
        throw InvalidInput(
            fmt::format("the {}-simplex with vertices {} has no volume: remove it or move a vertex",
                        k, fmt::join(list, ", ")));
    throw InvalidInput(fmt::format(
        "the {}-simplex with vertices {} has volume {:.3g}: scale the mesh to a size nearer to 1",
        k, fmt::join(list, ", "), sphere.volume()));
}

/// From the top down: what a k-simplex t hands to its face s is h(s, t) V(t), with h(s, t) =
/// barycentric coordinate * k |t| / |s|; the division by |s| comes last. Spheres are looked at
/// many at once, and their heights added one after the other.
void hand_down(const SimplicialComplex& complex, const SimplexMetric& metric, int k,
               CellVolumes& volumes) {
    const int n = complex.dimension();
    const Simplices& simplices = complex.simplices(k);
    const Points* const points = metric.points(); // asked once, not for every simplex
    Vector &primal = volumes.primal[k], &dual = volumes.dual[k], &lower = volumes.dual[k - 1];
    const auto measure = [&](Index first, Index last, double* height) {
        SimplexLayout layout(complex, metric);
        Circumsphere sphere;
        for (Index t = first; t < last; ++t) {
            sphere.look_at(points ? Corners{*points, vertices(simplices, t)} : layout.at(k, t));
            if (!is_moderate(sphere.volume()))
                refuse(complex, metric, k, t);
            primal[t] = sphere.volume();
            if (k < n)
                dual[t] /= (n - k) * primal[t];
            const double weight = k * primal[t] * dual[t];
            for (int i = k; i >= 0; --i)
                *height++ = sphere.barycentric(i) * weight;
        }
    };

    constexpr Index at_once = 1 << 15, part_size = 1 << 12;
    const Index* face = complex.coboundary(k - 1).innerIndexPtr();
    std::vector<double> heights;
    for (Index first = 0; first < complex.size(k); first += at_once) {
        const Index count = std::min(at_once, complex.size(k) - first);
        heights.resize(std::size_t(count) * (k + 1));
        for_each_part(count, part_size, [&](Index begin, Index end) {
            measure(first + begin, first + end, &heights[std::size_t(begin) * (k + 1)]);
        });
        for (const double height : heights)
            lower[*face++] += height;
    }
}

} // namespace

CellVolumes circumcentric_volumes(const SimplicialComplex& complex, const SimplexMetric& metric) {
    check_metric(complex, metric);
    const int n = complex.dimension();
    CellVolumes volumes;
    for (int k = 0; k <= n; ++k) {
        volumes.primal.emplace_back(complex.size(k));
        volumes.dual.emplace_back(Vector::Zero(complex.size(k)));
    }
    volumes.primal[0].setOnes();
    volumes.dual[n].setOnes();

    for (int k = n; k >= 1; --k)
        hand_down(complex, metric, k, volumes);
    volumes.dual[0] /= n;
    return volumes;
}

CellVolumes merged_volumes(std::span<const IncidenceMatrix> diamonds, const CellVolumes& input) {
    CellVolumes volumes;
    for (std::size_t k = 0; k < diamonds.size(); ++k) {
        const SparseMatrix pieces = diamonds[k].cast<double>().cwiseAbs();
        volumes.primal.emplace_back(pieces * input.primal[k]);
        const Vector products = pieces * input.primal[k].cwiseProduct(input.dual[k]);
        volumes.dual.emplace_back(products.cwiseQuotient(volumes.primal[k]));
    }
    return volumes;
}

CellVolumes merged_volumes(const Merging& merging, const CellVolumes& input) {
    return merged_volumes(merging.diamonds(), input);
}

} // namespace polydec
