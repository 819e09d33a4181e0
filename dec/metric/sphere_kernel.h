// SPDX-License-Identifier: MIT
#pragma once

#include "dec/metric/pack.h"
#include "dec/metric/rounding.h"
#include "dec/metric/two_doubles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

namespace polydec {

constexpr int most_vertices = 32; ///< of a simplex of a complex

/// Scale of the rounding error of a signed circumcentric distance h, or of one in each lane.
template <class Number>
struct HeightTermsOf {
    Number growth = 1, shift = 0;

    Number of(const Number& height) const {
        using std::abs;
        return growth * abs(height) + shift;
    }
};
using HeightTerms = HeightTermsOf<double>;

/// The numbers of one circumsphere, or of one in each lane: see Circumsphere.
template <class Number, int most = most_vertices>
struct SphereOf {
    Number volume = 0; ///< 0: there is no sphere
    Number squared_radius = 0;
    HeightTermsOf<Number> uncertainty, rounding;
    std::array<Number, most> barycentric{};
    std::array<Number, most> squared_slopes{}; ///< of the coordinates: 1 / height^2
};

/// Of Gram and Schmidt for one simplex, or for one in each lane. With fixed dimensions the compiler
/// unrolls all loops; -1 means any.
namespace sphere_kernel {

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
[[gnu::always_inline]] inline Number difference(const Plain<Number>& a, const Plain<Number>& b) {
    if constexpr (is_careful<Number>)
        return Number::difference(a, b);
    else
        return a - b;
}

inline double lane(double x, int) {
    return x;
}
inline double lane(const Pack& x, int l) {
    return x[l];
}

template <class Number>
constexpr int lanes = std::is_same_v<Number, Pack> ? Pack::size : 1;

/// Coordinate c of the corners at one position of each simplex.
template <class Number>
[[gnu::always_inline]] inline Plain<Number> coordinate(const double* const* corners, int c) {
    if constexpr (std::is_same_v<Number, Pack>)
        return {corners[0][c], corners[1][c]};
    else
        return corners[0][c];
}

/// Makes row i orthogonal to those before it, by modified Gram-Schmidt. Edge i = row i + sum over j
/// < i of triangle(i, j) row j; the diagonal of the triangle holds 1 / |row j|^2. The center is
/// where edge . x = |edge|^2 / 2 for every edge, and along(i) = row i . x. Returns |row i|^2.
template <class Number>
[[gnu::always_inline]] inline Number orthogonalize(int i, int k, int N, Number* basis,
                                                   Number* triangle, Number* along) {
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
[[gnu::always_inline]] inline void solve(int k, const Number* triangle, Number* center,
                                         Plain<Number>* barycentric) {
    Number rest = 1;
    for (int i = k - 1; i >= 0; --i) {
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
[[gnu::always_inline]] inline void square_slopes(int k, const Number* triangle, Number* column,
                                                 Plain<Number>* squares) {
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

/// The length l with rounding_of(l) = 2 error: rounding that moves both ends of an edge by `error`.
inline double last_digits(double error) {
    return 2 * error / rounding_of(1);
}

/// The center of an edge is its midpoint.
template <class Number, int N_fixed, int most>
[[gnu::always_inline]] inline void look_at_edge(SphereOf<Number, most>& sphere, int N_given,
                                                const double* const* corners, double error) {
    using std::abs, std::max, std::sqrt;
    const int N = N_fixed >= 0 ? N_fixed : N_given;
    Number squared = 0, reach = 0;
    for (int c = 0; c < N; ++c) {
        const Number tail = coordinate<Number>(corners, c);
        const Number head = coordinate<Number>(corners + lanes<Number>, c);
        squared = squared + (head - tail) * (head - tail);
        reach = max(reach, max(abs(head), abs(tail)));
    }
    sphere.volume = sqrt(squared);
    sphere.squared_radius = squared / 4;
    sphere.barycentric[0] = sphere.barycentric[1] = 0.5;
    sphere.squared_slopes[0] = sphere.squared_slopes[1] = 1 / squared;
    sphere.uncertainty = {1, std::numbers::sqrt2 * reach};
    const Number loss = std::numbers::sqrt2 * (1 + last_digits(error) / sphere.volume);
    sphere.rounding = {1 + loss, sphere.volume / 2 * loss};
}

/// Looks at one simplex for each lane of Number; corner i of simplex l is at corners[i * lanes +
/// l]. Volumes of simplices too flat for the digits of Number are 0. Without fixed dimensions there
/// must be room for k (N + k + 4) numbers. Every corner may be off by `error`.
template <class Number, int k_fixed, int N_fixed, int most>
[[gnu::always_inline]] inline void look(SphereOf<Plain<Number>, most>& sphere, int k_given,
                                        int N_given, const double* const* corners, double error,
                                        Number* room) {
    using std::abs, std::max, std::min, std::sqrt;
    if constexpr (k_fixed == 1)
        return look_at_edge<Number, N_fixed>(sphere, N_given, corners, error);
    constexpr int width = lanes<Plain<Number>>;
    const int k = k_fixed >= 0 ? k_fixed : k_given, N = N_fixed >= 0 ? N_fixed : N_given;
    Number fixed[k_fixed >= 0 ? k_fixed * (N_fixed + k_fixed + 4) + 1 : 1];
    Number* const basis = k_fixed >= 0 ? fixed : room; // k orthogonal rows of N numbers
    Number* const triangle = basis + k * N;            // see orthogonalize
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

    solve(k, triangle, center, sphere.barycentric.data());
    square_slopes(k, triangle, along + k, sphere.squared_slopes.data());
    Plain<Number> all_slopes = 0;
    for (int i = 0; i <= k; ++i)
        all_slopes = all_slopes + sphere.squared_slopes[i];
    sphere.squared_radius = static_cast<Plain<Number>>(squared_radius);
    const Plain<Number> slope = sqrt(all_slopes), radius = sqrt(sphere.squared_radius);
    Plain<Number> loss = sqrt(longest) * slope, whole = static_cast<Plain<Number>>(volume);
    if constexpr (is_careful<Number>)
        loss *= std::numeric_limits<double>::epsilon() * loss;
    else
        whole = sqrt(whole);
    sphere.volume = where_positive(margin, whole / factorial);
    sphere.uncertainty = {1, 2 * radius * reach * slope};
    loss = loss + last_digits(error) * slope;
    sphere.rounding = {1 + loss, radius * loss};
}

/// Scales of errors for corners placed by their distances: relative errors of the squared distances
/// move the center by these slopes.
template <class Number, int most>
[[gnu::always_inline]] inline void measure_distances(SphereOf<Number, most>& sphere, int k, int N,
                                                     const double* const* corners) {
    using std::abs, std::sqrt;
    constexpr int width = lanes<Number>;
    HeightTermsOf<Number> terms;
    std::array<Number, most> slopes;
    for (int i = 0; i <= k; ++i)
        slopes[i] = sqrt(sphere.squared_slopes[i]);
    for (int i = 0; i <= k; ++i)
        for (int j = i + 1; j <= k; ++j) {
            Number squared = 0;
            for (int c = 0; c < N; ++c) {
                const Number edge = coordinate<Number>(corners + i * width, c) -
                                    coordinate<Number>(corners + j * width, c);
                squared = squared + edge * edge;
            }
            terms.shift = terms.shift + squared * (slopes[i] * abs(sphere.barycentric[j]) +
                                                   slopes[j] * abs(sphere.barycentric[i]));
            terms.growth = terms.growth + squared * slopes[i] * slopes[j];
        }
    sphere.uncertainty = sphere.rounding = terms;
}

/// Calls with_dimensions.operator()<k, N>() for those that occur often, else <1, -1> or <-1, -1>.
void for_dimensions(int k, int N, auto with_dimensions) {
    switch (10 * N + k) {
    case 21:
        return with_dimensions.template operator()<1, 2>();
    case 31:
        return with_dimensions.template operator()<1, 3>();
    case 22:
        return with_dimensions.template operator()<2, 2>();
    case 32:
        return with_dimensions.template operator()<2, 3>();
    case 33:
        return with_dimensions.template operator()<3, 3>();
    default:
        return k == 1 ? with_dimensions.template operator()<1, -1>()
                      : with_dimensions.template operator()<-1, -1>();
    }
}

} // namespace sphere_kernel

} // namespace polydec
