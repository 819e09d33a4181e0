// SPDX-License-Identifier: MIT
#include "dec/metric/plane.h"

#include "complex/pieces.h"
#include "dec/metric/rounding.h"

#include <limits>
#include <utility>

namespace polydec {

std::vector<Eigen::Index> varying_coordinates(const Points& points) {
    std::vector<Eigen::Index> axes;
    for (Eigen::Index c = 0; c < points.cols(); ++c)
        if ((points.col(c).array() != points(0, c)).any())
            axes.push_back(c);
    return axes;
}

PlanePoints plane_points(const Points& points, int n) {
    if (points.cols() <= n || points.rows() <= n)
        return {};
    const auto varying = varying_coordinates(points);
    if (static_cast<int>(varying.size()) == n)
        return {points(Eigen::indexing::all, varying)};

    // in directions to the point farthest from the current plane, made orthogonal twice
    const Points from_first = points.rowwise() - points.row(0);
    Points off = from_first;
    DenseMatrix axes(points.cols(), n);
    for (int i = 0; i < n; ++i) {
        Eigen::Index farthest = 0;
        if (off.rowwise().squaredNorm().maxCoeff(&farthest) == 0)
            return {};
        const Vector axis = off.row(farthest).transpose();
        const auto before = axes.leftCols(i);
        axes.col(i) = (axis - before * (before.transpose() * axis)).normalized();
        off -= off * axes.col(i) * axes.col(i).transpose();
    }
    PlanePoints result{from_first * axes};
    off = from_first - result.points * axes.transpose();
    constexpr double last_digits = 32 * std::numeric_limits<double>::epsilon();
    const Vector rounding =
        last_digits * off.cwiseAbs() * points.cwiseAbs().colwise().maxCoeff().transpose();
    if ((off.rowwise().squaredNorm().array() > rounding.array()).any())
        return {};
    const double skew = (axes.transpose() * axes - DenseMatrix::Identity(n, n)).norm();
    const auto N = static_cast<double>(points.cols());
    result.error = off.rowwise().norm().maxCoeff() +
                   (skew + rounding_of(N)) * from_first.rowwise().norm().maxCoeff();
    return result;
}

SimplexMetric metric_in_plane(const Pieces& complex, const std::shared_ptr<const Points>& points) {
    constexpr double kept = 1e-11;
    PlanePoints plane = plane_points(*points, complex.dimension());
    if (plane.points.cols() == 0 || plane.error > kept * edge_lengths(complex, *points).minCoeff())
        return points;
    return {std::make_shared<const Points>(std::move(plane.points)), plane.error};
}

} // namespace polydec
