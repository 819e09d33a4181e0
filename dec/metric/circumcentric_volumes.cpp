// SPDX-License-Identifier: MIT
#include "base/parallel.h"
#include "dec/metric/center_heights.h"
#include "dec/metric/circumsphere.h"
#include "dec/metric/geometry.h"
#include "dec/metric/rounding.h"
#include "dec/metric/usable_volumes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace polydec {

namespace {

/// Sum that a simplex collects from its cofaces, or passes to its faces: its dual volume, and the
/// scale of the volume's errors, from uncertain input and from rounding. Terms still to be divided
/// by the simplex's own volume are separate from other terms.
template <class Number>
struct SumOf {
    Number dual = 0;
    std::array<Number, 2> products{}, shifts{};

    /// For a simplex with this volume, a fraction of the sum handed to it.
    SumOf divided(const Number& volume, double part) const {
        const Number quotient = part / volume;
        return {
            quotient * dual,
            {quotient * products[0] + part * shifts[0], quotient * products[1] + part * shifts[1]},
            {}};
    }
};

/// A sum as it is stored: first products, then shifts, each from uncertain input and from rounding.
struct Sum {
    double dual = 0;
    UpperHalves errors;

    SumOf<double> numbers() const {
        const Pack products = errors.first(), shifts = errors.second();
        return {dual, {products[0], products[1]}, {shifts[0], shifts[1]}};
    }
};

/// The sums of two simplices, one in each lane.
SumOf<Pack> packed(const SumOf<double>& a, const SumOf<double>& b) {
    return {{a.dual, b.dual},
            {Pack(a.products[0], b.products[0]), Pack(a.products[1], b.products[1])},
            {Pack(a.shifts[0], b.shifts[0]), Pack(a.shifts[1], b.shifts[1])}};
}

template <class Number>
Sum stored(const SumOf<Number>& sums, int l) {
    using sphere_kernel::lane;
    return {lane(sums.dual, l),
            {{lane(sums.products[0], l), lane(sums.products[1], l)},
             {lane(sums.shifts[0], l), lane(sums.shifts[1], l)}}};
}

/// Finds the corners of consecutive k-simplices, one in each lane.
class PackedPlaces {
public:
    PackedPlaces(const Pieces& complex, const SimplexMetric& metric, int k)
        : points_(metric.points() ? metric.points()->data() : nullptr),
          simplices_(complex.simplices(k)),
          layouts_{SimplexLayout(complex, metric), SimplexLayout(complex, metric)} {}

    /// Stores the place of corner i of simplex t + l at corners[i * Pack::size + l].
    [[gnu::always_inline]] void find(int k, int N, Index t, const double** corners) {
        constexpr Index ahead = 16;
        const auto soon = std::min(t + ahead, static_cast<Index>(simplices_.rows()) - Pack::size);
        for (int l = 0; l < Pack::size && points_ == nullptr; ++l) {
            const Corners own = layouts_[l].at(k, t + l);
            for (int i = 0; i <= k; ++i)
                corners[i * Pack::size + l] = own.place(own.vertices[i]);
        }
        for (int i = 0; i <= k && points_ != nullptr; ++i)
            for (int l = 0; l < Pack::size; ++l) {
                corners[i * Pack::size + l] = place(t + l, i, N);
                if (i > 0) // the first corner of several is the same
                    __builtin_prefetch(place(soon + l, i, N));
            }
    }

    SimplexLayout& layout() { return layouts_.front(); }

private:
    const double* place(Index t, int i, int N) const {
        return points_ + std::ptrdiff_t{simplices_(t, i)} * N;
    }

    const double* points_; // null if only lengths are known
    const Simplices& simplices_;
    std::array<SimplexLayout, Pack::size> layouts_;
};

/// Consecutive k-simplices and what they hand to their faces: a sum each, and for each corner the
/// factor of its dual and products.
struct Batch {
    Batch(int k, Index most)
        : shares(static_cast<std::size_t>(most)), numbers(std::size_t(most) * (k + 1)) {}

    Index first = 0, count = 0;
    std::vector<Sum> shares;
    std::vector<double> numbers;
};

/// How certain a simplex's heights and volume are.
template <class Number>
struct Terms {
    HeightTermsOf<Number> uncertain, rounded;
    Number volume_growth;
};

/// A volume below everything that rounding leaves of the last digits of the corners.
double least_volume(const Corners& corners) {
    const auto k = static_cast<double>(corners.vertices.size()) - 1;
    return std::numeric_limits<double>::epsilon() / 64 * std::pow(largest_extent(corners), k);
}

int exponent_of_lengths(const SimplexMetric& metric) {
    const double largest = metric.points() ? metric.points()->lpNorm<Eigen::Infinity>()
                                           : metric.lengths()->lpNorm<Eigen::Infinity>();
    return largest > 0 ? std::ilogb(largest) : 0;
}

/// Descends by degree: a k-simplex t hands h(s, t) V(t) to its face s, with h(s, t) = barycentric
/// coordinate * k |t| / |s|; the division by |s| comes last. Also hands down the magnitudes of the
/// terms that cancel in h(s, t) and in V(t). An error of |t| is also an error of V(t) / |t|.
class Descent {
public:
    Descent(const Pieces& complex, const SimplexMetric& metric, const Centers& centers,
            FlatSimplices flat)
        : complex_(complex),
          metric_(metric),
          centers_(centers),
          flat_(flat),
          exponent_(exponent_of_lengths(metric)) {}

    CellVolumes run() {
        const int n = complex_.dimension();
        degrees_.resize(n + 1);
        for (int k = n; k >= 1; --k)
            sphere_kernel::for_dimensions(k, coordinates(k), [&]<int k_fixed, int N_fixed> {
                hand_down<k_fixed, N_fixed>(k);
            });
        make_room(0);
        volumes_.setOnes();
        for (Index v = 0; v < complex_.size(0); ++v) {
            const auto own = sums_[v].numbers().divided(1, part(0));
            duals_[v] = own.dual;
            sizes_[v] = scale_.part(own.products[0]);
            lost_[v] = scale_.part(rounding_of(own.products[1]));
        }
        keep(0);
        return CellVolumes(std::move(degrees_));
    }

private:
    /// One thread adds, in order, what others have measured, while these measure the simplices
    /// behind.
    template <int k_fixed, int N_fixed>
    void hand_down(int k) {
        constexpr Index part_size = 1 << 11;
        const Index at_once = std::min(8 * part_size, complex_.size(k));
        make_room(k);
        std::vector<Sum> below(static_cast<std::size_t>(complex_.size(k - 1)));
        Batch measured(k, at_once), next(k, at_once);
        do {
            next.first = measured.first + measured.count;
            next.count = std::min(at_once, complex_.size(k) - next.first);
            for_each_part(1 + (next.count + part_size - 1) / part_size, 1, [&](Index part, Index) {
                if (part == 0)
                    return add<k_fixed>(k, measured, below);
                const Index begin = (part - 1) * part_size;
                measure<k_fixed, N_fixed>(k, next, begin, std::min(begin + part_size, next.count));
            });
            std::swap(measured, next);
        } while (measured.count > 0);
        sums_ = std::move(below);
        keep(k);
    }

    template <int k_fixed>
    void add(int k_given, const Batch& batch, std::vector<Sum>& below) {
        const int k = k_fixed >= 0 ? k_fixed : k_given;
        const FaceTable faces = complex_.faces(k);
        const double* number = batch.numbers.data();
        for (Index t = 0; t < batch.count; ++t) {
            const Sum& share = batch.shares[t];
            const Pack products = share.errors.first(), shifts = share.errors.second();
            constexpr Index ahead = 8;
            const Index soon = std::min(batch.first + t + ahead, complex_.size(k) - 1);
            __builtin_prefetch(&below[faces(soon, 0)]); // the others share a corner, so are nearby
            for (int i = 0; i <= k; ++i, ++number) {
                Sum& face = below[faces(batch.first + t, i)];
                face.dual += *number * share.dual;
                face.errors = {face.errors.first() + std::abs(*number) * products,
                               face.errors.second() + shifts};
            }
        }
    }

    /// Computes the volumes of the simplices begin .. end - 1 of a batch, and their shares.
    template <int k_fixed, int N_fixed>
    void measure(int k, Batch& batch, Index begin, Index end) {
        const bool in_lanes = centers_.are_circumcenters(k);
        std::vector<Pack> room(
            k_fixed >= 0 ? 0 : static_cast<std::size_t>(k * (coordinates(k) + k + 4)));
        PackedPlaces places(complex_, metric_, k);
        Circumsphere sphere;
        Sum* share = &batch.shares[begin];
        double* numbers = &batch.numbers[std::size_t(begin) * (k + 1)];
        for (Index t = batch.first + begin; t < batch.first + end;) {
            int count = Pack::size;
            if (!in_lanes || batch.first + end - t < count ||
                !measure_two<k_fixed, N_fixed>(k, t, places, room.data(), share, numbers)) {
                std::ignore = sphere.look_at(places.layout().at(k, t));
                measure_one(k, t, sphere, share, numbers);
                count = 1;
            }
            t += count;
            share += count;
            numbers += count * (k + 1);
        }
    }

    /// One simplex with any center, which may be flat.
    void measure_one(int k, Index t, const Circumsphere& sphere, Sum* share, double* numbers) {
        const bool is_top = k == complex_.dimension(), know = centers_.know(k);
        const bool may_be_flat = is_top && (know || flat_ == FlatSimplices::passed_over);
        const bool has_volume = sphere.volume() > 0;
        const double volume = has_volume || !may_be_flat
                                  ? sphere.volume()
                                  : least_volume(SimplexLayout(complex_, metric_).at(k, t));
        if (!is_moderate(volume))
            refuse_volume(complex_, metric_, k, t);
        const auto own =
            is_top ? SumOf<double>{1, {}, {}} : sums_[t].numbers().divided(volume, part(k));
        const double growth = has_volume ? sphere.rounding().growth : 1;
        if (!has_volume && !know) {
            settle<double>(k, t, volume, own, {{}, {}, growth}, 0);
            *share = {};
            std::fill_n(numbers, k + 1, 0);
            return;
        }
        const auto moments = centers_.moments(k, t, sphere);
        *share = stored(settle<double>(k, t, volume, own,
                                       {centers_.uncertainty(k, t, sphere),
                                        centers_.rounding(k, t, sphere), growth},
                                       moments.factor),
                        0);
        std::copy_n(moments.numbers, k + 1, numbers);
    }

    /// Two simplices of usual size with their circumcenters; returns false for others.
    template <int k_fixed, int N_fixed>
    [[gnu::always_inline]] bool measure_two(int k_given, Index t, PackedPlaces& places, Pack* room,
                                            Sum* share, double* numbers) {
        const int k = k_fixed >= 0 ? k_fixed : k_given;
        constexpr int most = k_fixed >= 0 ? k_fixed + 1 : most_vertices;
        const int N = N_fixed >= 0 ? N_fixed : coordinates(k);
        std::array<const double*, most * Pack::size> corners;
        places.find(k, N, t, corners.data());
        SphereOf<Pack, most> sphere;
        sphere_kernel::look<Pack, k_fixed, N_fixed>(sphere, k, N, corners.data(), metric_.error(),
                                                    room);
        if (!is_moderate(sphere.volume[0]) || !is_moderate(sphere.volume[1]))
            return false;
        if (metric_.lengths() != nullptr)
            sphere_kernel::measure_distances<Pack>(sphere, k, N, corners.data());
        const auto own = k == complex_.dimension()
                             ? SumOf<Pack>{1, {0, 0}, {0, 0}}
                             : packed(sums_[t].numbers(), sums_[t + 1].numbers())
                                   .divided(sphere.volume, part(k));
        const auto shares = settle<Pack>(
            k, t, sphere.volume, own, {sphere.uncertainty, sphere.rounding, sphere.rounding.growth},
            k * sphere.volume);
        for (int l = 0; l < Pack::size; ++l, numbers += k + 1) {
            share[l] = stored(shares, l);
            for (int i = 0; i <= k; ++i)
                numbers[i] = sphere.barycentric[i][l];
        }
        return true;
    }

    /// Stores what is found of k-simplex t, or of one in each lane, and returns what it hands down.
    template <class Number>
    [[gnu::always_inline]] SumOf<Number> settle(int k, Index t, const Number& volume,
                                                const SumOf<Number>& own,
                                                const Terms<Number>& terms, const Number& factor) {
        using std::abs;
        const auto& [uncertain, rounded, volume_growth] = terms;
        const Number size = abs(own.dual), lost = own.products[1] + volume_growth * size;
        put(volume, &volumes_[t]);
        put(own.dual, &duals_[t]);
        const Number size_of_terms = k == complex_.dimension() ? Number(1) : own.products[0];
        const Number rounding = rounding_of(1) * lost;
        for (int l = 0; l < sphere_kernel::lanes<Number>; ++l) {
            sizes_[t + l] = scale_.part(sphere_kernel::lane(size_of_terms, l));
            lost_[t + l] = scale_.part(sphere_kernel::lane(rounding, l));
        }
        // errors of h(s, t) and of V(t) both count
        const Number products[] = {uncertain.growth * size + own.products[0],
                                   rounded.growth * size + (centers_.know(k) ? 0 : lost)};
        return {factor * own.dual,
                {factor * products[0], factor * products[1]},
                {size * uncertain.shift, size * rounded.shift}};
    }

    int coordinates(int k) const { // of corners
        return metric_.points() ? static_cast<int>(metric_.points()->cols()) : k;
    }
    double part(int k) const { return 1.0 / (complex_.dimension() - k); }

    void make_room(int k) {
        for (Vector* values : {&volumes_, &duals_})
            values->resize(complex_.size(k));
        for (auto* bounds : {&sizes_, &lost_})
            bounds->resize(complex_.size(k));
        scale_ = Bounds::Scale((complex_.dimension() - k) * exponent_);
    }

    /// Stores the results on the k-simplices compactly.
    void keep(int k) {
        degrees_[k] = {std::exchange(volumes_, {}), std::exchange(duals_, {}),
                       Bounds(std::exchange(sizes_, {}), scale_),
                       Bounds(std::exchange(lost_, {}), scale_)};
    }

    const Pieces& complex_;
    const SimplexMetric& metric_;
    CenterHeights centers_;
    FlatSimplices flat_;
    std::vector<CellVolumes::Degree> degrees_;
    int exponent_; // of lengths
    // of the simplices being visited
    Vector volumes_, duals_;
    Column<Bounds::Part> sizes_, lost_;
    Bounds::Scale scale_{0};
    std::vector<Sum> sums_; // of the simplices being visited; none of highest degree
};

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
