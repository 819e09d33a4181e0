// SPDX-License-Identifier: MIT
#include "dec/metric/circumsphere.h"

#include "base/checks.h"
#include "base/errors.h"
#include "base/parallel.h"
#include "base/prefetch.h"
#include "dec/metric/pack.h"
#include "dec/metric/simplex_geometry.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

namespace polydec {

namespace {

/// Remainder of a vector after orthogonalization, relative to its length. Heights below the first
/// fraction of an edge cost too many digits of a double; below the second, vectors count as
/// linearly dependent.
constexpr double flat = 0.25, few_last_digits = 16 * std::numeric_limits<double>::epsilon();

template <class Number>
constexpr bool is_careful = std::is_same_v<Number, TwoDoubles>;

/// Type of results: one double per simplex.
template <class Number>
using Plain = std::conditional_t<is_careful<Number>, double, Number>;

template <class Number>
Number difference(const Plain<Number>& a, const Plain<Number>& b) {
    if constexpr (is_careful<Number>)
        return Number::difference(a, b);
    else
        return a - b;
}

constexpr double lane(double x, int) {
    return x;
}
double lane(const Pack& x, int l) {
    return x[l];
}

template <class Number>
constexpr int lanes = std::is_same_v<Number, Pack> ? Pack::size : 1;

/// Coordinate c of the corners at one position of each simplex.
template <class Number>
Plain<Number> coordinate(const double* const* corners, int c) {
    if constexpr (std::is_same_v<Number, Pack>)
        return {corners[0][c], corners[1][c]};
    else
        return corners[0][c];
}

/// Makes row i orthogonal to those before it, by modified Gram-Schmidt. Edge i = row i + sum over j
/// < i of triangle(i, j) row j; the diagonal of the triangle holds 1 / |row j|^2. The center is
/// where edge . x = |edge|^2 / 2 for every edge, and along(i) = row i . x. Returns |row i|^2.
template <class Number>
Number orthogonalize(int i, int k, int N, Number* basis, Number* triangle, Number* along) {
    Number* const row = basis + i * N;
    for (int j = 0; j < i; ++j) {
        const Number* const other = basis + j * N;
        Number product = 0;
        for (int c = 0; c < N; ++c)
            product = product + row[c] * other[c];
        product = product * triangle[j * k + j];
        for (int c = 0; c < N; ++c)
            row[c] = row[c] - product * other[c];
        triangle[i * k + j] = product;
        along[i] = along[i] - product * along[j];
    }
    Number squared = 0;
    for (int c = 0; c < N; ++c)
        squared = squared + row[c] * row[c];
    return squared;
}

/// Barycentric coordinates of the center = sum of barycentric * edges, given in the basis and
/// overwritten: solves with the transposed triangle.
template <class Number>
void solve(int k, const Number* triangle, Number* center, Plain<Number>* barycentric) {
    Number rest = 1;
    for (int i = k; i-- > 0;) {
        Number& value = center[i];
        for (int j = i + 1; j < k; ++j)
            value = value - triangle[j * k + i] * center[j];
        barycentric[i + 1] = static_cast<Plain<Number>>(value);
        rest = rest - value;
    }
    barycentric[0] = static_cast<Plain<Number>>(rest);
}

/// Squared slopes of the barycentric coordinates. Coordinate i + 1 has the slope sum of the inverse
/// triangle's column i times row j / |row j|^2; all slopes sum to zero. Needs room for two columns.
template <class Number>
void square_slopes(int k, const Number* triangle, Number* column, Plain<Number>* squares) {
    Number* const sums = column + k;
    std::fill(sums, sums + k, Number(0));
    for (int i = 0; i < k; ++i) {
        Number squared = 0;
        for (int j = i; j < k; ++j) {
            Number value = j == i ? 1 : 0;
            for (int m = i; m < j; ++m)
                value = value - triangle[j * k + m] * column[m];
            column[j] = value;
            sums[j] = sums[j] + value;
            squared = squared + value * value * triangle[j * k + j];
        }
        squares[i + 1] = static_cast<Plain<Number>>(squared);
    }
    Number squared = 0;
    for (int j = 0; j < k; ++j)
        squared = squared + sums[j] * sums[j] * triangle[j * k + j];
    squares[0] = static_cast<Plain<Number>>(squared);
}

} // namespace

/// Looks at one simplex per lane of Number; corner i of simplex l is at corners[i * lanes + l].
/// Fixed dimensions let the compiler unroll all loops; -1 means any. Flat simplices are recomputed
/// with twice the digits.
template <class Number, int k_fixed, int N_fixed>
void Circumsphere::look(Circumsphere* spheres, int k_given, int N_given,
                        const double* const* corners) {
    using std::abs, std::max, std::min, std::sqrt;
    constexpr int width = lanes<Number>;
    const int k = k_fixed >= 0 ? k_fixed : k_given, N = N_fixed >= 0 ? N_fixed : N_given;
    Number fixed[k_fixed >= 0 ? k_fixed * (N_fixed + k_fixed + 4) + 1 : 1];
    Number* scratch = fixed;
    if (k_fixed < 0) {
        auto& free = std::get<std::vector<Number>>(spheres->scratch_);
        free.resize(static_cast<std::size_t>(k * (N + k + 4)));
        scratch = free.data();
    }
    Number* const basis = scratch;           // k orthogonal rows of N numbers
    Number* const triangle = basis + k * N;  // see orthogonalize
    Number* const center = triangle + k * k; // circumcenter minus first vertex, in the basis
    Number* const along = center + k;        // and two columns behind
    Number volume = 1, squared_radius = 0;   // the first squared, unless careful
    double factorial = 1;
    Plain<Number> reach = 0, longest = 0; // largest coordinate, squared edge
    Plain<Number> margin = 1;             // negative for flat simplices
    for (int c = 0; c < N; ++c)
        reach = max(reach, abs(coordinate<Number>(corners, c)));

    for (int i = 0; i < k; ++i) {
        Number squared_length = 0;
        for (int c = 0; c < N; ++c) {
            const auto end = coordinate<Number>(corners + (i + 1) * width, c);
            Number& edge = basis[i * N + c];
            edge = difference<Number>(end, coordinate<Number>(corners, c));
            reach = max(reach, abs(end));
            squared_length = squared_length + edge * edge;
        }
        along[i] = squared_length / 2;
        const Number squared = orthogonalize(i, k, N, basis, triangle, along);
        const auto share = static_cast<Plain<Number>>(squared),
                   whole = static_cast<Plain<Number>>(squared_length);
        constexpr double least = is_careful<Number> ? few_last_digits : flat;
        margin = min(margin, share - least * least * whole);
        longest = max(longest, whole);
        volume = volume * (is_careful<Number> ? sqrt(squared) : squared);
        factorial *= i + 1;
        triangle[i * k + i] = 1 / squared;
        center[i] = along[i] * triangle[i * k + i];
        squared_radius = squared_radius + along[i] * center[i];
    }

    constexpr int most = k_fixed >= 0 ? k_fixed + 1 : most_vertices;
    std::array<Plain<Number>, most> barycentric, squared_slopes;
    solve(k, triangle, center, barycentric.data());
    square_slopes(k, triangle, along + k, squared_slopes.data());
    Plain<Number> all_slopes = 0;
    for (int i = 0; i <= k; ++i)
        all_slopes = all_slopes + squared_slopes[i];
    const auto squared = static_cast<Plain<Number>>(squared_radius);
    const Plain<Number> slope = sqrt(all_slopes), radius = sqrt(squared);
    Plain<Number> loss = sqrt(longest) * slope, whole = static_cast<Plain<Number>>(volume);
    if constexpr (is_careful<Number>)
        loss *= std::numeric_limits<double>::epsilon() * loss;
    else
        whole = sqrt(whole);
    const Plain<Number> shift = 2 * radius * reach * slope, lost = radius * loss;
    for (int l = 0; l < width; ++l) {
        Circumsphere& sphere = spheres[l];
        sphere.dimension_ = k;
        sphere.volume_ = lane(margin, l) > 0 ? lane(whole, l) / factorial : 0;
        sphere.squared_radius_ = lane(squared, l);
        for (int i = 0; i <= k; ++i)
            sphere.barycentric_[i] = lane(barycentric[i], l);
        if constexpr (width == 1)
            std::copy_n(squared_slopes.data(), k + 1, sphere.squared_slopes_.data());
        sphere.uncertainty_ = {1, lane(shift, l)};
        sphere.rounding_ = {1 + lane(loss, l), lane(lost, l)};
        if constexpr (!is_careful<Number>)
            if (constexpr double largest = 1e145; // its square is finite
                !(sphere.volume_ < largest && sphere.volume_ > 1 / largest)) {
                std::array<const double*, most_vertices> own;
                for (int i = 0; i <= k; ++i)
                    own[i] = corners[i * width + l];
                look<TwoDoubles, -1, -1>(&sphere, k, N, own.data());
            }
    }
}

/// The center of an edge is its midpoint.
template <class Number, int N_fixed>
void Circumsphere::look_at_edges(Circumsphere* spheres, int N_given, const double* const* corners) {
    using std::abs, std::max, std::sqrt;
    constexpr int width = lanes<Number>;
    const int N = N_fixed >= 0 ? N_fixed : N_given;
    Number squared = 0, reach = 0;
    for (int c = 0; c < N; ++c) {
        const Number tail = coordinate<Number>(corners, c);
        const Number head = coordinate<Number>(corners + width, c);
        squared = squared + (head - tail) * (head - tail);
        reach = max(reach, max(abs(head), abs(tail)));
    }
    const Number length = sqrt(squared);
    for (int l = 0; l < width; ++l) {
        Circumsphere& sphere = spheres[l];
        sphere.dimension_ = 1;
        sphere.volume_ = std::isfinite(lane(length, l)) ? lane(length, l) : 0;
        sphere.squared_radius_ = lane(squared, l) / 4;
        sphere.barycentric_[0] = sphere.barycentric_[1] = 0.5;
        sphere.squared_slopes_[0] = sphere.squared_slopes_[1] = 1 / lane(squared, l);
        sphere.uncertainty_ = {1, std::numbers::sqrt2 * lane(reach, l)};
        sphere.rounding_ = {1 + std::numbers::sqrt2, lane(length, l) / std::numbers::sqrt2};
    }
}

template <class Number>
void Circumsphere::look(Circumsphere* spheres, int k, int N, const double* const* corners) {
    switch (10 * N + k) {
    case 21:
        return look_at_edges<Number, 2>(spheres, N, corners);
    case 31:
        return look_at_edges<Number, 3>(spheres, N, corners);
    case 22:
        return look<Number, 2, 2>(spheres, k, N, corners);
    case 32:
        return look<Number, 2, 3>(spheres, k, N, corners);
    case 33:
        return look<Number, 3, 3>(spheres, k, N, corners);
    default:
        return k == 1 ? look_at_edges<Number, -1>(spheres, N, corners)
                      : look<Number, -1, -1>(spheres, k, N, corners);
    }
}

bool Circumsphere::look_at(std::span<const Index> vertices) {
    return look_at(Corners{*points_, vertices});
}

bool Circumsphere::look_at(const Corners& corners) {
    check_number("vertices of a simplex", std::ssize(corners.vertices), 1, most_vertices);
    const auto k = static_cast<int>(corners.vertices.size()) - 1;
    const auto N = static_cast<int>(corners.points.cols());
    volume_ = 0;
    if (k > N) // too many to be independent
        return false;
    std::array<const double*, most_vertices> places;
    for (int i = 0; i <= k; ++i)
        places[i] = corners.points.data() + std::ptrdiff_t{corners.vertices[i]} * N;
    look<double>(this, k, N, places.data());
    if (corners.by_lengths && volume_ > 0)
        measure_distances(corners);
    return volume_ > 0;
}

void Circumsphere::look_at(SimplexLayout& layout, int k, Index s) {
    if (!look_at(layout.at(k, s)))
        refuse_circumsphere(layout.complex().vertex_numbers(k, s));
}

void Circumsphere::measure_distances(const Corners& corners) {
    HeightTerms terms;
    std::array<double, most_vertices> slopes;
    for (int i = 0; i <= dimension_; ++i)
        slopes[i] = std::sqrt(squared_slopes_[i]);
    for (int i = 0; i <= dimension_; ++i)
        for (int j = i + 1; j <= dimension_; ++j) {
            const double squared =
                (corners.points.row(corners.vertices[i]) - corners.points.row(corners.vertices[j]))
                    .squaredNorm();
            terms.shift += squared * (slopes[i] * std::abs(barycentric_[j]) +
                                      slopes[j] * std::abs(barycentric_[i]));
            terms.growth += squared * slopes[i] * slopes[j];
        }
    uncertainty_ = rounding_ = terms;
}

void Circumsphere::refuse_flat() {
    throw InvalidInput("a simplex without volume has no circumsphere: remove it or move a vertex");
}

void refuse_circumsphere(std::span<const Index> vertices) {
    throw InvalidInput(fmt::format("the {}-simplex with vertices {} has no volume, and so no "
                                   "circumsphere: remove it or move a vertex",
                                   vertices.size() - 1, fmt::join(vertices, ", ")),
                       {.degree = static_cast<int>(vertices.size()) - 1,
                        .vertices = {vertices.begin(), vertices.end()}});
}

void Circumspheres::look_from(Index s) {
    const auto k = static_cast<int>(simplices_.cols()) - 1;
    const auto N = points_ ? static_cast<int>(points_->cols()) : 0;
    const auto last = static_cast<Index>(simplices_.rows()) - Pack::size;
    first_ = s;
    if (!points_ || k > N || s > last) {
        count_ = 1;
        std::ignore = spheres_[0].look_at(layout_ ? layout_->at(k, s)
                                                  : Corners{*points_, vertices(simplices_, s)});
        return;
    }
    count_ = Pack::size;
    const auto place = [&](Index t, int i) {
        return points_->data() + std::ptrdiff_t{simplices_(t, i)} * N;
    };
    constexpr Index ahead = 16;
    const Index soon = std::min(s + ahead, last);
    std::array<const double*, Circumsphere::most_vertices * Pack::size> places;
    for (int i = 0; i <= k; ++i)
        for (int l = 0; l < Pack::size; ++l) {
            places[i * Pack::size + l] = place(s + l, i);
            if (i > 0) // the first corner of several is the same
                prefetch(place(soon + l, i));
        }
    Circumsphere::look<Pack>(spheres_.data(), k, N, places.data());
}

} // namespace polydec
