// SPDX-License-Identifier: MIT
#include "base/checks.h"
#include "base/errors.h"
#include "base/parallel.h"
#include "base/prefetch.h"
#include "dec/metric/center_heights.h"
#include "dec/metric/circumsphere.h"
#include "dec/metric/geometry.h"
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

/// Products of a few volumes must neither overflow nor underflow.
bool is_moderate(double volume) {
    constexpr double largest = 1e100;
    return volume < largest && volume > 1 / largest;
}

/// The largest coordinate difference between two corners.
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

/// Names the simplex of least dimension, among t and its faces, whose volume is unusable.
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
                        "{:.3g}: products of such numbers overflow or underflow; scale the mesh to "
                        "a size nearer to 1, or remove its extremely small cells",
                        k, fmt::join(list, ", "), length, sphere.volume()),
            place);
    if (metric.lengths() != nullptr)
        throw InvalidInput(flaw_of_lengths(complex, metric, k, t), place);
    throw InvalidInput(
        fmt::format("the {}-simplex with vertices {} has no volume: remove it or move a vertex", k,
                    fmt::join(list, ", ")),
        place);
}

/// Sum that a simplex collects from its cofaces, or passes to its faces: its dual volume, and the
/// scale of the volume's errors, from uncertain input and from rounding. Terms still to be divided
/// by the simplex's own volume are separate from other terms.
struct Sum {
    double dual = 0;
    Pack products = 0, shifts = 0;

    /// For a simplex with this volume, a fraction of the sum handed to it.
    Sum divided(double volume, double part) const {
        const double quotient = part / volume;
        return {quotient * dual, quotient * products + part * shifts, 0};
    }
};

/// A volume below everything that rounding leaves of the last digits of the corners.
double least_volume(const Corners& corners) {
    const auto k = static_cast<double>(corners.vertices.size()) - 1;
    return std::numeric_limits<double>::epsilon() / 64 * std::pow(largest_extent(corners), k);
}

/// Descends by degree: a k-simplex t hands h(s, t) V(t) to its face s, with h(s, t) = barycentric
/// coordinate * k |t| / |s|; the division by |s| comes last. Also hands down the magnitudes of the
/// terms that cancel in h(s, t) and in V(t). An error of |t| is also an error of V(t) / |t|.
class Descent {
public:
    Descent(const Pieces& complex, const SimplexMetric& metric, const Centers& centers,
            FlatSimplices flat)
        : complex_(complex), metric_(metric), centers_(centers), flat_(flat) {}

    CellVolumes run();

private:
    /// Computes the volumes of k-simplices first .. last - 1, and what they hand to their faces:
    /// one sum each, and per corner the factors of its dual and products.
    void measure(int k, Index first, Index last, Sum* share, double* numbers);
    void hand_down(int k);
    void make_room(int k);
    void keep(int k);

    const Pieces& complex_;
    const SimplexMetric& metric_;
    CenterHeights centers_;
    FlatSimplices flat_;
    std::vector<Values> primal_, dual_;
    std::vector<Bounds> terms_, rounding_;
    Vector volumes_, duals_, sizes_, lost_; // of the simplices being visited
    std::vector<Sum> sums_; // of the simplices being visited; none of highest degree
};

void Descent::measure(int k, Index first, Index last, Sum* share, double* numbers) {
    const int n = complex_.dimension();
    const bool is_top = k == n, know = centers_.know(k);
    const bool may_be_flat = is_top && (know || flat_ == FlatSimplices::passed_over);
    Circumspheres spheres(complex_, metric_, k);
    double *const volumes = volumes_.data(), *const duals = duals_.data();
    double *const sizes = sizes_.data(), *const roundings = lost_.data();
    const double part = is_top ? 1 : 1.0 / (n - k);
    for (Index t = first; t < last; ++t, ++share, numbers += k + 1) {
        const Circumsphere& sphere = spheres[t];
        const bool has_volume = sphere.volume() > 0;
        const double volume = has_volume || !may_be_flat
                                  ? sphere.volume()
                                  : least_volume(SimplexLayout(complex_, metric_).at(k, t));
        if (!is_moderate(volume))
            refuse(complex_, metric_, k, t);
        const Sum own = is_top ? Sum{1, 0, 0} : sums_[t].divided(volume, part);
        const double size = std::abs(own.dual);
        const double lost = own.products[1] + (has_volume ? sphere.rounding().growth : 1) * size;
        volumes[t] = volume;
        duals[t] = own.dual;
        sizes[t] = is_top ? 1 : own.products[0];
        roundings[t] = rounding_of(lost);
        if (!has_volume && !know) {
            *share = {};
            std::fill_n(numbers, k + 1, 0);
            continue;
        }

        // errors of h(s, t) and of V(t) both count
        const auto uncertain = centers_.uncertainty(k, t, sphere);
        const auto rounded = centers_.rounding(k, t, sphere);
        const auto moments = centers_.moments(k, t, sphere);
        const Pack products(uncertain.growth * size + own.products[0],
                            rounded.growth * size + (know ? 0 : lost));
        *share = {moments.factor * own.dual, moments.factor * products,
                  size * Pack(uncertain.shift, rounded.shift)};
        for (int i = 0; i <= k; ++i)
            numbers[i] = moments.numbers[i];
    }
}

/// Measures many simplices in parallel, and adds their contributions sequentially.
void Descent::hand_down(int k) {
    constexpr Index part_size = 1 << 11;
    const Index at_once = std::min(8 * part_size, complex_.size(k));
    make_room(k);
    const FaceTable faces = complex_.faces(k);
    std::vector<Sum> below(static_cast<std::size_t>(complex_.size(k - 1)));
    std::vector<Sum> shares(static_cast<std::size_t>(at_once));
    std::vector<double> numbers(std::size_t(at_once) * (k + 1));
    for (Index first = 0; first < complex_.size(k); first += at_once) {
        const Index count = std::min(at_once, complex_.size(k) - first);
        for_each_part(count, part_size, [&](Index begin, Index end) {
            measure(k, first + begin, first + end, &shares[begin],
                    &numbers[std::size_t(begin) * (k + 1)]);
        });
        const double* number = numbers.data();
        for (Index t = 0; t < count; ++t) {
            const Sum share = shares[t];
            constexpr Index ahead = 8;
            const Index soon = std::min(first + t + ahead, complex_.size(k) - 1);
            prefetch(&below[faces(soon, 0)]); // the others share a corner, so are nearby
            for (int i = 0; i <= k; ++i, ++number) {
                Sum& face = below[faces(first + t, i)];
                face.dual += *number * share.dual;
                face.products = face.products + std::abs(*number) * share.products;
                face.shifts = face.shifts + share.shifts;
            }
        }
    }
    sums_ = std::move(below);
    keep(k);
}

void Descent::make_room(int k) {
    for (Vector* values : {&volumes_, &duals_, &sizes_, &lost_})
        values->resize(complex_.size(k));
}

/// Stores the results on the k-simplices compactly.
void Descent::keep(int k) {
    primal_[k] = std::exchange(volumes_, {});
    dual_[k] = std::exchange(duals_, {});
    terms_[k] = std::exchange(sizes_, {});
    rounding_[k] = std::exchange(lost_, {});
}

CellVolumes Descent::run() {
    const int n = complex_.dimension();
    for (auto* values : {&primal_, &dual_})
        values->resize(n + 1);
    for (auto* bounds : {&terms_, &rounding_})
        bounds->resize(n + 1);
    for (int k = n; k >= 1; --k)
        hand_down(k);
    make_room(0);
    volumes_.setOnes();
    for (Index v = 0; v < complex_.size(0); ++v) {
        const Sum own = sums_[v].divided(1, 1.0 / n);
        duals_[v] = own.dual;
        sizes_[v] = own.products[0];
        lost_[v] = rounding_of(own.products[1]);
    }
    keep(0);
    return {std::move(primal_), std::move(dual_), std::move(terms_), std::move(rounding_)};
}

} // namespace

CellVolumes circumcentric_volumes(const Pieces& complex, const SimplexMetric& metric) {
    return dual_volumes(complex, metric, Centers());
}

CellVolumes dual_volumes(const Pieces& complex, const SimplexMetric& metric, const Centers& centers,
                         FlatSimplices flat) {
    check_metric(complex, metric);
    centers.check_fit(complex);
    return Descent(complex, metric, centers, flat).run();
}

} // namespace polydec
