// SPDX-License-Identifier: MIT
#include "dec/merging/mean_spheres.h"

#include "dec/metric/circumsphere.h"
#include "dec/metric/simplex_geometry.h"

#include <cmath>
#include <utility>

namespace polydec {

MeanSpheres::MeanSpheres(const Geometry& geometry, const std::vector<bool>& flat)
    : complex_(geometry.pieces()),
      metric_(geometry.metric()),
      points_(*metric_.points()),
      volumes_(geometry.volumes()),
      flat_(flat),
      normal_(complex_.dimension(), complex_.dimension() - 1) {
    const int n = complex_.dimension();
    const Index size = complex_.size(n);
    own_ = Points::Zero(size, n);
    moments_ = Points::Zero(size, n + 1);
    terms_ = Points::Zero(size, 4);
    SimplexLayout layout(complex_, metric_);
    Circumsphere sphere;
    for (Index t = 0; t < size; ++t) {
        const auto corners = layout.at(n, t);
        if (!sphere.look_at(corners))
            continue; // not part of any dual unless it shares its center
        for (int i = 0; i <= n; ++i) {
            own_.row(t) += sphere.barycentric(i) *
                           (points_.row(corners.vertices[i]) - points_.row(corners.vertices[0]));
            moments_(t, i) = sphere.barycentric(i) * (n * sphere.volume());
        }
        const auto &uncertainty = sphere.uncertainty(), &rounding = sphere.rounding();
        terms_.row(t) << uncertainty.growth, uncertainty.shift, rounding.growth, rounding.shift;
    }
}

Eigen::RowVectorXd MeanSpheres::away(Index root, Index v) const {
    return points_.row(v) - means_.origins.row(root) - means_.centers.row(root);
}

void MeanSpheres::gather(const std::vector<Index>& roots) {
    const int n = complex_.dimension();
    const Index size = complex_.size(n);
    const auto& simplices = complex_.simplices(n);
    const Vector& volumes = volumes_.primal(n);
    auto& [origins, centers, terms, counts, sides] = means_;
    origins.resize(size, n);
    centers = Points::Zero(size, n);
    terms = Points::Zero(size, terms_.cols());
    counts.assign(static_cast<std::size_t>(size), 0);
    sides = Vector::Zero(size);
    Vector weights = Vector::Zero(size);
    for (Index t = 0; t < size; ++t) {
        const Index root = roots[t];
        origins.row(t) = points_.row(simplices(t, 0));
        ++counts[root];
        if (is_flat(t))
            continue;
        weights[root] += volumes[t];
        centers.row(root) +=
            volumes[t] * (origins.row(t) - points_.row(simplices(root, 0)) + own_.row(t));
        terms.row(root) += volumes[t] * terms_.row(t);
        if (!flat_.empty())
            sides[root] += own_side(t);
    }
    for (Index t = 0; t < size; ++t)
        if (weights[t] > 0) {
            centers.row(t) /= weights[t];
            terms.row(t) /= weights[t];
        }
    radii_ = Vector::Zero(size);
    for (Index t = 0; t < size; ++t)
        if (!is_flat(t))
            for (const Index v : simplices.row(t))
                radii_[roots[t]] +=
                    volumes[t] / (n + 1) * away(roots[t], v).squaredNorm() / weights[roots[t]];
    radii_ = radii_.cwiseSqrt();
    roots_ = roots;
}

void MeanSpheres::gather(const std::vector<Index>& roots, Means means) {
    roots_ = roots;
    means_ = std::move(means);
}

Vector MeanSpheres::normal(Index t, int i) const {
    return area_vector(normal_, points_, complex_, complex_.face(complex_.dimension(), t, i));
}

double MeanSpheres::own_side(Index t) const {
    if (is_flat(t))
        return 0;
    const int n = complex_.dimension();
    const auto& simplices = complex_.simplices(n);
    const Eigen::RowVectorXd inwards = points_.row(simplices(t, 0)) - points_.row(simplices(t, 1));
    return std::copysign(volumes_.primal(n)[t], complex_.sign(n, t, 0) * normal(t, 0).dot(inwards));
}

double MeanSpheres::distance(Index root, Index v) const {
    const double r = radii_[root];
    return std::abs(away(root, v).norm() - r) * (away(root, v).norm() + r) / (2 * r);
}

double MeanSpheres::between(Index root, Index other) const {
    return (means_.origins.row(other) + means_.centers.row(other) - means_.origins.row(root) -
            means_.centers.row(root))
        .norm();
}

Centers MeanSpheres::shared_centers() const {
    const int n = complex_.dimension();
    const Index size = complex_.size(n);
    const auto& simplices = complex_.simplices(n);
    Points moments = moments_, terms = terms_;
    for (Index t = 0; t < size; ++t) {
        const Index root = roots_[t];
        if (means_.counts[root] == 1)
            continue;
        terms.row(t) = means_.terms.row(root);
        const double side = std::copysign(1, is_flat(t) ? means_.sides[root] : own_side(t));
        for (int i = 0; i <= n; ++i)
            moments(t, i) = -side * complex_.sign(n, t, i) *
                            normal(t, i).dot(away(root, simplices(t, i == 0 ? 1 : 0)));
    }
    return Centers::of_cells(std::move(moments), std::move(terms));
}

} // namespace polydec
