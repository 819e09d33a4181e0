// SPDX-License-Identifier: MIT
#include "dec/metric/circumsphere.h"

#include "base/checks.h"
#include "base/errors.h"
#include "base/parallel.h"
#include "dec/metric/simplex_geometry.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace polydec {

namespace {

/// What orthogonalizing leaves of a vector that is linearly dependent, relative to its length.
constexpr double few_last_digits = 16 * std::numeric_limits<double>::epsilon();

/// Heights below this share of an edge cost too many digits.
constexpr double flat = 0.25;

template <class Number>
Number difference(double a, double b) {
    if constexpr (std::is_same_v<Number, double>)
        return a - b;
    else
        return Number::difference(a, b);
}

/// Barycentric coordinates of the center = sum of barycentric * edges, which stands in the basis
/// and is overwritten: solves with the transposed triangle.
template <class Number>
void solve(int k, const Number* triangle, Number* center, double* barycentric) {
    Number rest = 1;
    for (int i = k; i-- > 0;) {
        Number& value = center[i];
        for (int j = i + 1; j < k; ++j)
            value = value - triangle[j * k + i] * center[j];
        barycentric[i + 1] = static_cast<double>(value);
        rest = rest - value;
    }
    barycentric[0] = static_cast<double>(rest);
}

/// make() gives a function, for one thread, that makes a sphere look at simplex s.
template <class Make>
Vector radii_of(Index count, Make make) {
    constexpr Index part_size = 1 << 13;
    Vector radii(count);
    for_each_part(count, part_size, [&](Index begin, Index end) {
        auto look = make();
        Circumsphere sphere;
        for (Index s = begin; s < end; ++s) {
            look(sphere, s);
            radii[s] = sphere.radius();
        }
    });
    return radii;
}

/// Throws InvalidInput for a vertex without point.
void check_table(const Points& points, const Simplices& simplices) {
    for (const Index vertex : simplices.reshaped())
        check_number("the point", vertex, 0, points.rows() - 1);
}

[[noreturn]] void refuse(std::span<const Index> vertices) {
    throw InvalidInput(fmt::format("the {}-simplex with vertices {} has no volume, and so no "
                                   "circumsphere: remove it or move a vertex",
                                   vertices.size() - 1, fmt::join(vertices, ", ")),
                       {.degree = static_cast<int>(vertices.size()) - 1,
                        .vertices = {vertices.begin(), vertices.end()}});
}

void look_at_row(Circumsphere& sphere, const Points& points, const Simplices& simplices, Index s) {
    const auto row = vertices(simplices, s);
    if (!sphere.look_at(Corners{points, row}))
        refuse(row);
}

} // namespace

/// Slope of coordinate i + 1 = sum of the inverse triangle's column i times row j / |row j|^2; all
/// slopes sum to zero. There is room for two columns behind the pointer.
template <class Number, int k_fixed>
void Circumsphere::measure_slopes(const Number* triangle, Number* column, double reach,
                                  double longest) {
    const int k = k_fixed >= 0 ? k_fixed : dimension_;
    Number* const sums = column + k;
    std::fill(sums, sums + k, Number(0));
    double all_slopes = 0;
    const auto add = [&](int i, const Number& squared) {
        squared_slopes_[i] = static_cast<double>(squared);
        all_slopes += squared_slopes_[i];
    };
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
        add(i + 1, squared);
    }
    Number squared = 0;
    for (int j = 0; j < k; ++j)
        squared = squared + sums[j] * sums[j] * triangle[j * k + j];
    add(0, squared);
    const double slope = std::sqrt(all_slopes), radius = std::sqrt(squared_radius_);
    uncertainty_ = {1, 2 * radius * reach * slope};
    double loss = longest * slope;
    if constexpr (!std::is_same_v<Number, double>)
        loss *= std::numeric_limits<double>::epsilon() * loss;
    rounding_ = {1 + loss, radius * loss};
}

/// Dimensions that are fixed let the compiler unroll all loops; -1 stands for any. Orthogonalizing
/// loses as many digits as heights are smaller than edges, so flat simplices are looked at again
/// with twice the digits.
template <class Number, int k_fixed, int N_fixed>
bool Circumsphere::look(std::span<const Index> vertices) {
    using std::sqrt;
    const int k = k_fixed >= 0 ? k_fixed : static_cast<int>(vertices.size()) - 1;
    const int N = N_fixed >= 0 ? N_fixed : static_cast<int>(points_->cols());
    Number fixed[k_fixed >= 0 ? k_fixed * (N_fixed + k_fixed + 4) + 1 : 1];
    Number* scratch = fixed;
    if (k_fixed < 0) {
        auto& free = std::get<std::vector<Number>>(scratch_);
        free.resize(static_cast<std::size_t>(k * (N + k + 4)));
        scratch = free.data();
    }
    Number* const basis = scratch;           // k orthogonal rows of N numbers
    Number* const triangle = basis + k * N;  // edge i = row i + sum over j < i of (i, j) row j
    Number* const center = triangle + k * k; // circumcenter minus first vertex, in the basis
    const double* const origin = points_->data() + std::ptrdiff_t{vertices[0]} * N;
    Number volume = 1, squared_radius = 0;
    dimension_ = k;
    double reach = 0, longest = 0; // largest coordinate, squared edge
    for (int c = 0; c < N; ++c)
        reach = std::max(reach, std::abs(origin[c]));

    // modified Gram-Schmidt; the center is where edge . x = |edge|^2 / 2 for every edge, and
    // along(i) = row i . x. The diagonal of the triangle holds 1 / |row i|^2.
    Number* const along = center + k;
    for (int i = 0; i < k; ++i) {
        Number* const row = basis + i * N;
        const double* const corner = points_->data() + std::ptrdiff_t{vertices[i + 1]} * N;
        Number squared_length = 0;
        for (int c = 0; c < N; ++c) {
            row[c] = difference<Number>(corner[c], origin[c]);
            reach = std::max(reach, std::abs(corner[c]));
            squared_length = squared_length + row[c] * row[c];
        }
        along[i] = squared_length / 2;
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
        const auto share = static_cast<double>(squared),
                   whole = static_cast<double>(squared_length);
        longest = std::max(longest, whole);
        if constexpr (std::is_same_v<Number, double>)
            if (share < flat * flat * whole)
                return look<TwoDoubles, -1, -1>(vertices);
        if (!(share > few_last_digits * few_last_digits * whole)) {
            volume_ = 0;
            return false;
        }
        volume = volume * (sqrt(squared) / (i + 1));
        triangle[i * k + i] = 1 / squared;
        center[i] = along[i] * triangle[i * k + i];
        squared_radius = squared_radius + along[i] * center[i];
    }
    volume_ = static_cast<double>(volume);
    squared_radius_ = static_cast<double>(squared_radius);

    solve(k, triangle, center, barycentric_.data());
    measure_slopes<Number, k_fixed>(triangle, along + k, reach, std::sqrt(longest));
    return true;
}

bool Circumsphere::look_at(std::span<const Index> vertices) {
    check_number("vertices of a simplex", static_cast<std::int64_t>(vertices.size()), 1,
                 most_vertices);
    if (static_cast<Eigen::Index>(vertices.size()) > points_->cols() + 1) {
        volume_ = 0; // too many to be independent
        return false;
    }
    switch (10 * static_cast<int>(points_->cols()) + static_cast<int>(vertices.size()) - 1) {
    case 11:
        return look<double, 1, 1>(vertices);
    case 21:
        return look<double, 1, 2>(vertices);
    case 22:
        return look<double, 2, 2>(vertices);
    case 31:
        return look<double, 1, 3>(vertices);
    case 32:
        return look<double, 2, 3>(vertices);
    case 33:
        return look<double, 3, 3>(vertices);
    default:
        return look<double, -1, -1>(vertices);
    }
}

bool Circumsphere::look_at(const Corners& corners) {
    points_ = &corners.points;
    const bool has_volume = look_at(corners.vertices);
    if (has_volume && corners.by_lengths)
        measure_distances(corners);
    return has_volume;
}

void Circumsphere::look_at(SimplexLayout& layout, int k, Index s) {
    if (!look_at(layout.at(k, s)))
        refuse(layout.complex().vertex_numbers(k, s));
}

void Circumsphere::measure_distances(const Corners& corners) {
    HeightTerms terms;
    std::array<double, most_vertices> slopes;
    for (int i = 0; i <= dimension_; ++i)
        slopes[i] = std::sqrt(squared_slopes_[i]);
    for (int i = 0; i <= dimension_; ++i)
        for (int j = 0; j <= dimension_; ++j) {
            if (i == j)
                continue;
            const double squared =
                (corners.points.row(corners.vertices[i]) - corners.points.row(corners.vertices[j]))
                    .squaredNorm();
            terms.shift += squared * slopes[i] * std::abs(barycentric_[j]);
            terms.growth += squared * slopes[i] * slopes[j] / 2;
        }
    uncertainty_ = rounding_ = terms;
}

void Circumsphere::refuse_flat() {
    throw InvalidInput("a simplex without volume has no circumsphere: remove it or move a vertex");
}

Vector circumradii(const Points& points, const Simplices& simplices) {
    check_table(points, simplices);
    return radii_of(static_cast<Index>(simplices.rows()), [&] {
        return [&](Circumsphere& sphere, Index s) { look_at_row(sphere, points, simplices, s); };
    });
}

Vector circumradii(const Pieces& complex, const SimplexMetric& metric, int k) {
    check_number("circumradii in degree", k, 0, complex.dimension());
    return radii_of(complex.size(k), [&] {
        return [k, layout = SimplexLayout(complex, metric)](Circumsphere& sphere, Index s) mutable {
            sphere.look_at(layout, k, s);
        };
    });
}

Points circumcenters(const Points& points, const Simplices& simplices) {
    require_points(points.cols(), "a circumcenter");
    check_table(points, simplices);
    Circumsphere sphere;
    Points centers = Points::Zero(simplices.rows(), points.cols());
    for (Index s = 0; s < simplices.rows(); ++s) {
        look_at_row(sphere, points, simplices, s);
        for (Index i = 0; i < simplices.cols(); ++i)
            centers.row(s) += sphere.barycentric(i) * points.row(simplices(s, i));
    }
    return centers;
}

} // namespace polydec
