// SPDX-License-Identifier: MIT
#include "meshes/tetgen/tetrahedron_sign.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace polydec {

namespace {

using Pair = std::array<double, 2>; // a number as a double and what that lacks

Pair exact_sum(double a, double b) {
    const double sum = a + b, b_in_sum = sum - a;
    return {sum, (a - (sum - b_in_sum)) + (b - b_in_sum)};
}

Pair exact_product(double a, double b) {
    const double product = a * b;
    return {product, std::fma(a, b, -product)};
}

/// An exact sum, as terms of ascending size that do not overlap.
class ExactSum {
public:
    void add(double term) {
        std::size_t kept = 0;
        for (const double part : parts_) {
            const auto [sum, rest] = exact_sum(term, part);
            if (rest != 0.0)
                parts_[kept++] = rest;
            term = sum;
        }
        parts_.resize(kept);
        if (term != 0.0)
            parts_.push_back(term);
    }
    int sign() const { return parts_.empty() ? 0 : parts_.back() > 0.0 ? 1 : -1; }

private:
    std::vector<double> parts_;
};

int exact_sign(const Eigen::Vector3d& a, const std::array<const Eigen::Vector3d*, 3>& corners) {
    std::array<std::array<Pair, 3>, 3> edges;
    for (std::size_t i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            edges[i][j] = exact_sum((*corners[i])[j], -a[j]);

    constexpr int terms[6][4] = {{0, 1, 2, 1},  {1, 2, 0, 1},  {2, 0, 1, 1},
                                 {0, 2, 1, -1}, {2, 1, 0, -1}, {1, 0, 2, -1}};
    ExactSum sum;
    for (const auto& [i, j, k, sign] : terms)
        for (const double x : edges[0][i])
            for (const double y : edges[1][j])
                for (const double xy : exact_product(sign * x, y))
                    for (const double z : edges[2][k])
                        for (const double xyz : exact_product(xy, z))
                            sum.add(xyz);
    return sum.sign();
}

} // namespace

int tetrahedron_sign(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                     const Eigen::Vector3d& d) {
    constexpr double rounding = 32.0 * std::numeric_limits<double>::epsilon();
    const Eigen::Vector3d p = b - a, q = c - a, r = d - a;
    const double volume = p.cross(q).dot(r);
    if (std::abs(volume) > rounding * p.norm() * q.norm() * r.norm())
        return volume > 0.0 ? 1 : -1;
    return exact_sign(a, {&b, &c, &d});
}

} // namespace polydec
