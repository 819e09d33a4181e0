// SPDX-License-Identifier: MIT
#include "dec/circumsphere.h"

#include "base/checks.h"
#include "base/parallel.h"
#include "dec/simplex_geometry.h"

#include <cmath>
#include <limits>

namespace polydec {

namespace {

/// What orthogonalizing leaves of a vector that is linearly dependent, relative to its length.
constexpr double few_last_digits = 16 * std::numeric_limits<double>::epsilon();

/// make() gives a function, for one thread, that places the corners of simplex s.
template <class Make>
Vector radii_of(Index count, Make make) {
    constexpr Index part_size = 1 << 13;
    Vector radii(count);
    for_each_part(count, part_size, [&](Index begin, Index end) {
        auto corners = make();
        Circumsphere sphere;
        for (Index s = begin; s < end; ++s) {
            sphere.look_at(corners(s));
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

} // namespace

/// Dimensions that are fixed let the compiler unroll all loops; -1 stands for any.
template <int k_fixed, int N_fixed>
bool Circumsphere::look(std::span<const Index> vertices) {
    const int k = k_fixed >= 0 ? k_fixed : static_cast<int>(vertices.size()) - 1;
    const int N = N_fixed >= 0 ? N_fixed : static_cast<int>(points_->cols());
    double fixed[k_fixed >= 0 ? k_fixed * (N_fixed + k_fixed + 2) + 1 : 1];
    double* scratch = fixed;
    if (k_fixed < 0) {
        scratch_.resize(static_cast<std::size_t>(k * (N + k + 2)));
        scratch = scratch_.data();
    }
    double* const basis = scratch;           // k orthogonal rows of N numbers
    double* const triangle = basis + k * N;  // edge i = row i + sum over j < i of (i, j) row j
    double* const center = triangle + k * k; // circumcenter minus first vertex, in the basis
    const double* const origin = points_->data() + std::ptrdiff_t{vertices[0]} * N;
    dimension_ = k;
    volume_ = 1;
    squared_radius_ = 0;

    // modified Gram-Schmidt; the center is where edge . x = |edge|^2 / 2 for every edge, and
    // along(i) = row i . x. The diagonal of the triangle holds 1 / |row i|^2.
    double* const along = center + k;
    for (int i = 0; i < k; ++i) {
        double* const row = basis + i * N;
        const double* const corner = points_->data() + std::ptrdiff_t{vertices[i + 1]} * N;
        double squared_length = 0;
        for (int c = 0; c < N; ++c) {
            row[c] = corner[c] - origin[c];
            squared_length += row[c] * row[c];
        }
        along[i] = squared_length / 2;
        for (int j = 0; j < i; ++j) {
            const double* const other = basis + j * N;
            double product = 0;
            for (int c = 0; c < N; ++c)
                product += row[c] * other[c];
            product *= triangle[j * k + j];
            for (int c = 0; c < N; ++c)
                row[c] -= product * other[c];
            triangle[i * k + j] = product;
            along[i] -= product * along[j];
        }
        double squared = 0;
        for (int c = 0; c < N; ++c)
            squared += row[c] * row[c];
        volume_ *= std::sqrt(squared) / (i + 1);
        if (!(squared > few_last_digits * few_last_digits * squared_length)) {
            volume_ = 0;
            return false;
        }
        triangle[i * k + i] = 1 / squared;
        center[i] = along[i] * triangle[i * k + i];
        squared_radius_ += along[i] * center[i];
    }

    // center = sum of barycentric * edges: solve with the transposed triangle
    double rest = 1;
    for (int i = k; i-- > 0;) {
        double value = center[i];
        for (int j = i + 1; j < k; ++j)
            value -= triangle[j * k + i] * barycentric_[j + 1];
        barycentric_[i + 1] = value;
        rest -= value;
    }
    barycentric_[0] = rest;
    return true;
}

bool Circumsphere::look_at(std::span<const Index> vertices) {
    switch (10 * static_cast<int>(points_->cols()) + static_cast<int>(vertices.size()) - 1) {
    case 21:
        return look<1, 2>(vertices);
    case 22:
        return look<2, 2>(vertices);
    case 31:
        return look<1, 3>(vertices);
    case 32:
        return look<2, 3>(vertices);
    case 33:
        return look<3, 3>(vertices);
    default:
        return look<-1, -1>(vertices);
    }
}

Vector circumradii(const Points& points, const Simplices& simplices) {
    check_table(points, simplices);
    return radii_of(static_cast<Index>(simplices.rows()), [&] {
        return [&](Index s) { return Corners{points, vertices(simplices, s)}; };
    });
}

Vector circumradii(const SimplicialComplex& complex, const SimplexMetric& metric, int k) {
    check_number("circumradii in degree", k, 0, complex.dimension());
    return radii_of(complex.size(k), [&] {
        return [k, layout = SimplexLayout(complex, metric)](Index s) mutable {
            return layout.at(k, s);
        };
    });
}

Points circumcenters(const Points& points, const Simplices& simplices) {
    require_points(points.cols(), "a circumcenter");
    check_table(points, simplices);
    Circumsphere sphere(points);
    Points centers = Points::Zero(simplices.rows(), points.cols());
    for (Index s = 0; s < simplices.rows(); ++s) {
        sphere.look_at(vertices(simplices, s));
        for (Index i = 0; i < simplices.cols(); ++i)
            centers.row(s) += sphere.barycentric(i) * points.row(simplices(s, i));
    }
    return centers;
}

} // namespace polydec
