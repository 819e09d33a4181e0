// SPDX-License-Identifier: MIT
#include "dec/circumsphere.h"

#include "dec/simplex_geometry.h"

#include <cmath>
#include <limits>

namespace polydec {

namespace {

/// What orthogonalizing leaves of a vector that is linearly dependent, relative to its length.
constexpr double few_last_digits = 16 * std::numeric_limits<double>::epsilon();

} // namespace

bool Circumsphere::look_at(std::span<const Index> vertices) {
    const auto k = vertices.size() - 1, N = static_cast<std::size_t>(points_.cols());
    basis_.resize(k * N);
    triangle_.assign(k * k, 0.0);
    center_.assign(k, 0.0);
    barycentric_.assign(k + 1, 0.0);
    volume_ = 1;
    const double* origin = points_.data() + vertices[0] * N;

    // edges = triangle * basis, by modified Gram-Schmidt; the center is where |x|^2 = edge . x for
    // every edge, that is triangle * center = squared edge lengths / 2
    for (std::size_t i = 0; i < k; ++i) {
        double* row = basis_.data() + i * N;
        const double* corner = points_.data() + vertices[i + 1] * N;
        double squared_length = 0;
        for (std::size_t c = 0; c < N; ++c) {
            row[c] = corner[c] - origin[c];
            squared_length += row[c] * row[c];
        }
        double right_side = squared_length / 2;
        for (std::size_t j = 0; j < i; ++j) {
            const double* other = basis_.data() + j * N;
            double product = 0;
            for (std::size_t c = 0; c < N; ++c)
                product += row[c] * other[c];
            for (std::size_t c = 0; c < N; ++c)
                row[c] -= product * other[c];
            triangle_[i * k + j] = product;
            right_side -= product * center_[j];
        }
        double squared = 0;
        for (std::size_t c = 0; c < N; ++c)
            squared += row[c] * row[c];
        const double length = std::sqrt(squared);
        volume_ *= length / static_cast<double>(i + 1);
        if (!(length > few_last_digits * std::sqrt(squared_length))) {
            volume_ = 0;
            return false;
        }
        for (std::size_t c = 0; c < N; ++c)
            row[c] /= length;
        triangle_[i * k + i] = length;
        center_[i] = right_side / length;
    }

    // center = sum of barycentric * edges: solve with the transposed triangle
    double squared_radius = 0, rest = 1;
    for (std::size_t i = k; i-- > 0;) {
        squared_radius += center_[i] * center_[i];
        double value = center_[i];
        for (std::size_t j = i + 1; j < k; ++j)
            value -= triangle_[j * k + i] * barycentric_[j + 1];
        barycentric_[i + 1] = value / triangle_[i * k + i];
        rest -= barycentric_[i + 1];
    }
    barycentric_[0] = rest;
    radius_ = std::sqrt(squared_radius);
    return true;
}

Vector circumradii(const Points& points, const Simplices& simplices) {
    Circumsphere sphere(points);
    Vector radii(simplices.rows());
    for (Index s = 0; s < simplices.rows(); ++s) {
        sphere.look_at(vertices(simplices, s));
        radii[s] = sphere.radius();
    }
    return radii;
}

Points circumcenters(const Points& points, const Simplices& simplices) {
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
