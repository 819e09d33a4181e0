// SPDX-License-Identifier: MIT
#include "dec/metric/plane.h"

#include "complex/pieces.h"
#include "dec/metric/rounding.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace polydec {

std::vector<Eigen::Index> varying_coordinates(const Points& points) {
    std::vector<Eigen::Index> axes;
    for (Eigen::Index c = 0; c < points.cols() && points.rows() > 0; ++c)
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
    DenseMatrix axes = DenseMatrix::Zero(points.cols(), n);
    const auto each_block = [&](const auto& look) { // few points at a time, until `look` says false
        constexpr Eigen::Index most = 1 << 10;
        bool again = true;
        for (Eigen::Index begin = 0; again && begin < points.rows(); begin += most) {
            const auto block = points.middleRows(begin, std::min(most, points.rows() - begin));
            const Points from_first = block.rowwise() - points.row(0), along = from_first * axes;
            again = look(begin, along, from_first - along * axes.transpose());
        }
        return again;
    };
    double size = 0;
    for (int i = 0; i < n; ++i) {
        double farthest = 0;
        Vector axis;
        each_block([&](Eigen::Index, const Points&, const Points& off) {
            Eigen::Index row = 0;
            if (const double squared = off.rowwise().squaredNorm().maxCoeff(&row);
                squared > farthest) {
                farthest = squared;
                axis = off.row(row).transpose();
            }
            return true;
        });
        if (farthest == 0)
            return {};
        if (i == 0)
            size = axis.norm();
        axes.col(i) = (axis - axes * (axes.transpose() * axis)).normalized();
    }
    PlanePoints result{Points(points.rows(), n)};
    constexpr double last_digits = 32 * std::numeric_limits<double>::epsilon();
    const Vector rounding = last_digits * points.cwiseAbs().colwise().maxCoeff().transpose();
    double off_plane = 0;
    const bool all = each_block([&](Eigen::Index begin, const Points& along, const Points& off) {
        result.points.middleRows(begin, along.rows()) = along;
        off_plane = std::max(off_plane, off.rowwise().norm().maxCoeff());
        return (off.rowwise().squaredNorm().array() <= (off.cwiseAbs() * rounding).array()).all();
    });
    if (!all)
        return {};
    const double skew = (axes.transpose() * axes - DenseMatrix::Identity(n, n)).norm();
    const auto N = static_cast<double>(points.cols());
    result.error = off_plane + (skew + rounding_of(N)) * size;
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
