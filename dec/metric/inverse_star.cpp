// SPDX-License-Identifier: MIT
#include "dec/metric/inverse_star.h"

#include "base/decompositions.h"
#include "dec/metric/simplex_faces.h"
#include "dec/metric/simplex_geometry.h"
#include "dec/metric/subsets.h"

#include <cmath>

namespace polydec {

InverseStar::InverseStar(int N, int m, int j)
    : m_(m),
      j_(j),
      minors_(m, m - j),
      tangents_(N, j),
      faces_(subsets(m + 1, m - j + 1)),
      axes_(subsets(m, j)),
      wedge_(std::ssize(axes_), tangents_.size()) {}

void InverseStar::look_at(const DenseMatrix& corners, int orientation) {
    corners_ = corners;
    const DenseMatrix edges = corners.bottomRows(m_).rowwise() - corners.row(0);
    frame_ = orthonormal_columns(edges.transpose());
    const double determinant = (edges * frame_).determinant();
    volume_ = std::abs(determinant) / std::tgamma(m_ + 1.0);

    const double side = (determinant < 0 ? -1 : 1) * orientation;
    const std::size_t count = axes_.size();
    for (std::size_t I = 0; I < count; ++I) {
        const auto& axes = axes_[count - 1 - I]; // the complement of the I-th subset
        int transpositions = (m_ - j_) * j_;     // axes of vectors come first
        for (int i = 0; i < j_; ++i)
            transpositions += axes[i] - i;
        const double sign = transpositions % 2 == 0 ? side : -side;
        wedge_.row(static_cast<Index>(I)) =
            sign * tangents_(frame_(Eigen::indexing::all, axes).transpose()).transpose();
    }
}

Eigen::RowVectorXd InverseStar::at(const DenseMatrix& vectors) const {
    return minors_(vectors * frame_).transpose() * wedge_;
}

DenseMatrix InverseStar::over_faces() const {
    const int k = m_ - j_;
    DenseMatrix result(std::ssize(faces_), wedge_.cols());
    DenseMatrix edges(k, corners_.cols());
    for (std::size_t f = 0; f < faces_.size(); ++f) {
        for (int i = 0; i < k; ++i)
            edges.row(i) = corners_.row(faces_[f][i + 1]) - corners_.row(faces_[f][0]);
        result.row(static_cast<Index>(f)) = at(edges) / std::tgamma(k + 1.0);
    }
    return result;
}

Vector inverse_star_means(const Pieces& complex, const Points& points, const Simplices& corners,
                          int j,
                          const std::function<Eigen::RowVectorXd(Index t, Index s)>& coefficients) {
    const int n = complex.dimension(), k = n - j;
    InverseStar star(static_cast<int>(points.cols()), n, j);
    SimplexFaces faces(complex, n, k);
    Vector sums = Vector::Zero(complex.size(k)), volumes = sums;
    for (Index t = 0; t < complex.size(n); ++t) {
        star.look_at(points(vertices(corners, t), Eigen::indexing::all), complex.orientation(t));
        const DenseMatrix rows = star.over_faces();
        const auto& list = faces.of(t);
        for (Index i = 0; i < rows.rows(); ++i) {
            const Index s = list[i];
            sums[s] +=
                orientation(complex, k, s) * star.volume() * rows.row(i).dot(coefficients(t, s));
            volumes[s] += star.volume();
        }
    }
    return (volumes.array() > 0).select(sums.cwiseQuotient(volumes), 0);
}

} // namespace polydec
