// SPDX-License-Identifier: MIT
#include "dec/metric/plane.h"

#include "complex/pieces.h"

#include <limits>

namespace polydec {

std::vector<Eigen::Index> varying_coordinates(const Points& points) {
    std::vector<Eigen::Index> axes;
    for (Eigen::Index c = 0; c < points.cols(); ++c)
        if ((points.col(c).array() != points(0, c)).any())
            axes.push_back(c);
    return axes;
}

Points plane_points(const Points& points, int n) {
    if (points.cols() <= n || points.rows() <= n)
        return {};
    const auto axes = varying_coordinates(points);
    if (static_cast<int>(axes.size()) == n)
        return points(Eigen::indexing::all, axes);

    // in directions to the point farthest from the current plane
    const double rounding =
        32 * std::numeric_limits<double>::epsilon() * points.cwiseAbs().maxCoeff();
    Points off = points.rowwise() - points.row(0), result(points.rows(), n);
    for (int i = 0; i < n; ++i) {
        Eigen::Index farthest = 0;
        if (off.rowwise().squaredNorm().maxCoeff(&farthest) == 0)
            return {};
        const Vector axis = off.row(farthest).normalized();
        result.col(i) = off * axis;
        off -= result.col(i) * axis.transpose();
    }
    return off.cwiseAbs().maxCoeff() <= rounding ? result : Points();
}

SimplexMetric metric_in_plane(const Pieces& complex, const std::shared_ptr<const Points>& points) {
    constexpr double kept = 1e-12;
    Points plane = plane_points(*points, complex.dimension());
    if (plane.cols() == 0)
        return points;
    const Vector lengths = edge_lengths(complex, *points);
    const Vector changes = (edge_lengths(complex, plane) - lengths).cwiseAbs();
    if ((changes.array() > kept * lengths.array()).any())
        return points;
    return plane;
}

} // namespace polydec
