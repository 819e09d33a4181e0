// SPDX-License-Identifier: MIT
#include "dec/metric/angle_sums.h"

#include "dec/metric/simplex_faces.h"

#include <cmath>
#include <limits>

namespace polydec {

namespace {

/// Angles between the facets of one simplex at a time.
class Dihedral {
public:
    /// n-simplices in R^N.
    Dihedral(int n, Eigen::Index N) : rows_(n, N) {}

    /// Whether the volume is that of rounding, beside the product of the edges from one corner.
    bool is_flat(const Corners& corners) {
        double share = 1;
        for (int i = 0; i < rows_.rows(); ++i) {
            const double length = place(corners, 0, i + 1, i);
            share *= length > 0 ? orthogonalize(i, i) / length : 0;
        }
        const auto n = static_cast<double>(rows_.rows());
        return !(share > 64 * n * std::numeric_limits<double>::epsilon()); // not a number, too
    }

    /// The angle at a face between the facets that have one of the two other corners each: between
    /// the heights of these over the face.
    double angle(const Corners& corners, const std::vector<int>& face,
                 const std::vector<int>& others) {
        const auto k = static_cast<int>(face.size()) - 1;
        for (int i = 0; i < k; ++i) {
            place(corners, face[0], face[i + 1], i);
            orthogonalize(i, i);
        }
        for (int i = 0; i < 2; ++i) {
            place(corners, face[0], others[i], k + i);
            orthogonalize(k + i, k);
        }
        double difference = 0, sum = 0; // squared
        for (int c = 0; c < rows_.cols(); ++c) {
            const double x = rows_(k, c), y = rows_(k + 1, c);
            difference += (x - y) * (x - y);
            sum += (x + y) * (x + y);
        }
        return 2 * std::atan2(std::sqrt(difference), std::sqrt(sum));
    }

private:
    /// Makes the edge between two corners a row, and returns its length.
    double place(const Corners& corners, int from, int to, int row) {
        const auto N = rows_.cols();
        const double* const tail = corners.points.data() + corners.vertices[from] * N;
        const double* const head = corners.points.data() + corners.vertices[to] * N;
        double squared = 0;
        for (int c = 0; c < N; ++c) {
            const double x = head[c] - tail[c];
            rows_(row, c) = x;
            squared += x * x;
        }
        return std::sqrt(squared);
    }

    /// Makes a row a unit vector orthogonal to the first `before`, and returns what it had of it.
    double orthogonalize(int row, int before) {
        double* const x = &rows_(row, 0);
        const auto N = rows_.cols();
        for (int j = 0; j < before; ++j) {
            const double* const y = &rows_(j, 0);
            double product = 0;
            for (int c = 0; c < N; ++c)
                product += x[c] * y[c];
            for (int c = 0; c < N; ++c)
                x[c] -= product * y[c];
        }
        double squared = 0;
        for (int c = 0; c < N; ++c)
            squared += x[c] * x[c];
        const double rest = std::sqrt(squared);
        for (int c = 0; c < N; ++c)
            x[c] /= rest;
        return rest;
    }

    Points rows_;
};

} // namespace

void for_each_angle(const Pieces& complex, const SimplexMetric& metric,
                    const std::function<void(Index, Index, Index, double)>& take) {
    const int n = complex.dimension();
    SimplexFaces faces(complex, n, n - 2);
    SimplexLayout layout(complex, metric);
    Dihedral dihedral(n, metric.points() ? metric.points()->cols() : n);
    for (Index t = 0; t < complex.size(n); ++t) {
        const Corners corners = layout.at(n, t);
        if (dihedral.is_flat(corners))
            continue;
        const auto& list = faces.of(t);
        for (Index i = 0; i < std::ssize(list); ++i)
            take(t, i, list[i], dihedral.angle(corners, faces.positions()[i], faces.omitted()[i]));
    }
}

Vector angle_sums(const Pieces& complex, const SimplexMetric& metric) {
    Vector sums = Vector::Zero(complex.size(complex.dimension() - 2));
    for_each_angle(complex, metric, [&](Index, Index, Index s, double angle) { sums[s] += angle; });
    return sums;
}

} // namespace polydec
