// SPDX-License-Identifier: MIT
#include "dec/metric/angle_sums.h"

#include "dec/metric/simplex_faces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polydec {

/// Makes the edge between two points row i, and returns its length.
template <int N_fixed>
double Heights::place(const Points& points, Index from, Index to, int i) {
    auto edge = row<N_fixed>(i);
    edge = (points.row(to) - points.row(from)).transpose();
    return edge.norm();
}

/// Makes row i a unit vector orthogonal to the first `before`, and returns the length of its
/// orthogonal part. A second pass removes the rounding of the first.
template <int N_fixed>
double Heights::orthogonalize(int i, int before, int passes) {
    auto x = row<N_fixed>(i);
    for (int pass = 0; pass < passes; ++pass)
        for (int j = 0; j < before; ++j)
            x -= x.dot(row<N_fixed>(j)) * row<N_fixed>(j);
    const double rest = x.norm();
    x /= rest;
    return rest;
}

bool Heights::is_flat(const Corners& corners) {
    double share = 1;
    for (int i = 0; i < rows_.rows(); ++i) {
        const double length =
            place<-1>(corners.points, corners.vertices[0], corners.vertices[i + 1], i);
        share *= length > 0 ? orthogonalize<-1>(i, i, 1) / length : 0;
    }
    const auto n = static_cast<double>(rows_.rows());
    return !(share > 64 * n * std::numeric_limits<double>::epsilon()); // not a number, too
}

template <int N_fixed>
Heights::Lengths Heights::measure(std::span<const Index> face, std::array<Index, 2> corners,
                                  const Points& points) {
    const auto k = static_cast<int>(face.size()) - 1;
    for (int i = 0; i < k; ++i) {
        place<N_fixed>(points, face[0], face[i + 1], i);
        orthogonalize<N_fixed>(i, i, 2);
    }
    for (int i = 0; i < 2; ++i) {
        place<N_fixed>(points, face[0], corners[i], k + i);
        orthogonalize<N_fixed>(k + i, k, 2);
    }
    const auto x = row<N_fixed>(k), y = row<N_fixed>(k + 1);
    return {(x + y).norm(), (x - y).norm()};
}

Heights::Lengths Heights::over(std::span<const Index> face, std::array<Index, 2> corners,
                               const Points& points) {
    return rows_.cols() == 3 ? measure<3>(face, corners, points)
                             : measure<-1>(face, corners, points);
}

void for_each_angle(const Pieces& complex, const SimplexMetric& metric,
                    const std::vector<bool>& around,
                    const std::function<void(Index, Index, Index, double)>& take) {
    const int n = complex.dimension();
    SimplexFaces faces(complex, n, n - 2);
    SimplexLayout layout(complex, metric);
    Heights heights(n, metric.points() ? metric.points()->cols() : n);
    std::vector<Index> face;
    const auto is_marked = [&](Index s) { return around.empty() || around[s]; };
    for (Index t = 0; t < complex.size(n); ++t) {
        const auto& list = faces.of(t);
        if (std::ranges::none_of(list, is_marked))
            continue;
        const Corners corners = layout.at(n, t);
        const auto corner = [&](int position) { return corners.vertices[position]; };
        const bool is_flat = heights.is_flat(corners);
        for (Index i = 0; i < std::ssize(list) && !is_flat; ++i) {
            if (!is_marked(list[i]))
                continue;
            face.resize(faces.positions()[i].size());
            std::ranges::transform(faces.positions()[i], face.begin(), corner);
            const auto& others = faces.omitted()[i];
            const auto [sum, difference] =
                heights.over(face, {corner(others[0]), corner(others[1])}, corners.points);
            take(t, i, list[i], 2 * std::atan2(difference, sum));
        }
    }
}

Vector angle_sums(const Pieces& complex, const SimplexMetric& metric,
                  const std::vector<bool>& around) {
    Vector sums = Vector::Zero(complex.size(complex.dimension() - 2));
    for_each_angle(complex, metric, around,
                   [&](Index, Index, Index s, double angle) { sums[s] += angle; });
    return sums;
}

} // namespace polydec
