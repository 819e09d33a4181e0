// SPDX-License-Identifier: MIT
#include "dec/metric/circumcentric_volumes.h"

#include "base/checks.h"
#include "base/errors.h"
#include "base/parallel.h"
#include "dec/metric/circumsphere.h"
#include "dec/metric/rounding.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace polydec {

namespace {

void check_points(const Pieces& complex, const Points& points) {
    require_straight(complex, points, "a volume");
    if (points.cols() < complex.dimension())
        throw InvalidInput(fmt::format("simplices of dimension {} do not fit into {} coordinates",
                                       complex.dimension(), points.cols()));
    for (Index v = 0; v < points.rows(); ++v)
        if (!points.row(v).allFinite())
            throw InvalidInput(fmt::format("vertex {} has a coordinate that is not finite",
                                           complex.vertex_number(v)),
                               {.vertices = {complex.vertex_number(v)}});
}

void check_metric(const Pieces& complex, const SimplexMetric& metric) {
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

/// The largest difference of a coordinate between two corners.
double largest_extent(const Corners& corners) {
    double extent = 0;
    for (Eigen::Index c = 0; c < corners.points.cols(); ++c) {
        double least = corners.points(corners.vertices[0], c), most = least;
        for (const Index v : corners.vertices) {
            least = std::min(least, corners.points(v, c));
            most = std::max(most, corners.points(v, c));
        }
        extent = std::max(extent, most - least);
    }
    return extent;
}

/// Names the simplex of least dimension, of those with t, whose volume is of no use.
[[noreturn]] void refuse(const Pieces& complex, const SimplexMetric& metric, int k, Index t) {
    SimplexLayout layout(complex, metric);
    Circumsphere sphere;
    for (int m = 1; m < k; ++m)
        for (Index s = 0; s < complex.size(m); ++s)
            if (!sphere.look_at(layout.at(m, s)) || !is_moderate(sphere.volume()))
                refuse(complex, metric, m, s);
    const auto list = complex.vertex_numbers(k, t);
    const Error::Place place{.degree = k, .cells = {t}, .vertices = list};
    const bool has_volume = sphere.look_at(layout.at(k, t));
    const double length = k > 0 ? largest_extent(layout.at(k, t)) : 1;
    if (has_volume || (length > 0 && !is_moderate(length)))
        throw InvalidInput(
            fmt::format("the {}-simplex with vertices {} has edges of about {:.3g} and volume "
                        "{:.3g}: products of such numbers are none; scale the mesh to a size "
                        "nearer to 1, or leave out what is so much smaller",
                        k, fmt::join(list, ", "), length, sphere.volume()),
            place);
    if (metric.lengths() != nullptr)
        throw InvalidInput(flaw_of_lengths(complex, metric, k, t), place);
    throw InvalidInput(
        fmt::format("the {}-simplex with vertices {} has no volume: remove it or move a vertex", k,
                    fmt::join(list, ", ")),
        place);
}

/// To what errors of the dual volumes are in proportion. What is still to be divided by a simplex's
/// own volume, and what is not, stands in two vectors.
struct Terms {
    /// What a simplex hands to a face: the errors of h(s, t) and of V(t) count.
    struct Share {
        double product, shift;
    };

    /// Of a simplex with this dual volume, of which `own` is off.
    static Share share(const HeightTerms& heights, double dual, double own, double height) {
        return {std::abs(height) * (heights.growth * std::abs(dual) + own),
                heights.shift * std::abs(dual)};
    }

    void add(int k, Index s, const Share& share) {
        products[k][s] += share.product;
        shifts[k][s] += share.shift;
    }

    void divide(int k, Index s, double volume, int n) {
        products[k][s] = (products[k][s] / volume + shifts[k][s]) / (n - k);
    }

    std::vector<Vector> products, shifts;
};

/// Volumes on the way down.
struct Sums {
    explicit Sums(const Pieces& complex) {
        for (int k = 0; k <= complex.dimension(); ++k) {
            primal.emplace_back(Vector::Ones(complex.size(k)));
            dual.emplace_back(Vector::Zero(complex.size(k)));
        }
        uncertain = rounded = {dual, dual};
        dual.back().setOnes();
    }

    void divide(int k, Index t, int n) {
        const double volume = primal[k][t];
        dual[k][t] /= (n - k) * volume;
        uncertain.divide(k, t, volume, n);
        rounded.divide(k, t, volume, n);
    }

    std::vector<Vector> primal, dual;
    Terms uncertain, rounded;
};

/// A volume below all that rounding leaves of the last digits of the corners.
double least_volume(const Corners& corners) {
    const auto k = static_cast<double>(corners.vertices.size()) - 1;
    return std::numeric_limits<double>::epsilon() / 64 * std::pow(largest_extent(corners), k);
}

/// From the top down: what a k-simplex t hands to its face s is h(s, t) V(t), with h(s, t) =
/// barycentric coordinate * k |t| / |s|; the division by |s| comes last. With it go the sizes of
/// what cancels, in h(s, t) and in V(t). An error of |t| is one of V(t) / |t| too. Spheres are
/// looked at many at once, and their heights added one after the other.
void hand_down(const Pieces& complex, const SimplexMetric& metric, const Centers& centers, int k,
               FlatSimplices flat, Sums& sums) {
    const int n = complex.dimension();
    const Simplices& simplices = complex.simplices(k);
    const Points* const points = metric.points(); // asked once, not for every simplex
    Vector &primal = sums.primal[k], &dual = sums.dual[k];
    Vector &uncertain = sums.uncertain.products[k], &rounded = sums.rounded.products[k];
    struct Share {
        double dual;
        Terms::Share uncertain, rounded;
    };
    const auto measure = [&](Index first, Index last, Share* share) {
        SimplexLayout layout(complex, metric);
        Circumsphere sphere;
        for (Index t = first; t < last; ++t) {
            const Corners corners =
                points ? Corners{*points, vertices(simplices, t)} : layout.at(k, t);
            const bool has_volume = sphere.look_at(corners);
            const bool may_be_flat =
                k == n && (centers.know(k) || flat == FlatSimplices::passed_over);
            primal[t] = has_volume || !may_be_flat ? sphere.volume() : least_volume(corners);
            if (!is_moderate(primal[t]))
                refuse(complex, metric, k, t);
            if (k < n)
                sums.divide(k, t, n);
            rounded[t] += (has_volume ? sphere.rounding().growth : 1) * std::abs(dual[t]);
            if (!has_volume && !centers.know(k)) {
                share = std::fill_n(share, k + 1, Share{});
                continue;
            }
            const auto uncertainty = centers.uncertainty(k, t, sphere);
            const auto rounding = centers.rounding(k, t, sphere);
            const double own = centers.know(k) ? 0 : rounded[t];
            for (int i = k; i >= 0; --i) {
                const double moment = centers.moment(k, t, i, sphere);
                *share++ = {moment * dual[t],
                            Terms::share(uncertainty, dual[t], uncertain[t], moment),
                            Terms::share(rounding, dual[t], own, moment)};
            }
        }
    };

    constexpr Index at_once = 1 << 15, part_size = 1 << 12;
    const FaceTable faces = complex.faces(k);
    std::vector<Share> shares;
    for (Index first = 0; first < complex.size(k); first += at_once) {
        const Index count = std::min(at_once, complex.size(k) - first);
        shares.resize(std::size_t(count) * (k + 1));
        for_each_part(count, part_size, [&](Index begin, Index end) {
            measure(first + begin, first + end, &shares[std::size_t(begin) * (k + 1)]);
        });
        const Share* share = shares.data();
        for (Index t = first; t < first + count; ++t)
            for (int i = k; i >= 0; --i, ++share) {
                const Index face = faces(t, i);
                sums.dual[k - 1][face] += share->dual;
                sums.uncertain.add(k - 1, face, share->uncertain);
                sums.rounded.add(k - 1, face, share->rounded);
            }
    }
}

} // namespace

CellVolumes circumcentric_volumes(const Pieces& complex, const SimplexMetric& metric) {
    return dual_volumes(complex, metric, Centers());
}

CellVolumes dual_volumes(const Pieces& complex, const SimplexMetric& metric, const Centers& centers,
                         FlatSimplices flat) {
    check_metric(complex, metric);
    centers.check_fit(complex);
    const int n = complex.dimension();
    Sums sums(complex);
    for (int k = n; k >= 1; --k)
        hand_down(complex, metric, centers, k, flat, sums);
    for (Index v = 0; v < complex.size(0); ++v)
        sums.divide(0, v, n);
    sums.uncertain.products[n].setOnes();
    for (Vector& terms : sums.rounded.products)
        terms = terms.unaryExpr(&rounding_of);
    return {std::move(sums.primal), std::move(sums.dual), std::move(sums.uncertain.products),
            std::move(sums.rounded.products)};
}

} // namespace polydec
