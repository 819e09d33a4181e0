// SPDX-License-Identifier: MIT
#pragma once

#include "io/pictures/draw_solid.h"
#include "io/pictures/svg_layout.h"

#include <vector>

namespace polydec {

/// From points in space to pixels to the right and down, and nearness to the eye in pixels.
class Projection {
public:
    using Place = Eigen::Vector3d;

    /// The points with these numbers, if any, fill the frame. Points have three coordinates.
    Projection(const SolidView& view, const Points& points, const std::vector<Index>& numbers,
               const SvgBox& frame);

    Place operator()(const Place& point) const {
        return center_ + (scale_ * (axes_ * point - middle_)).cwiseProduct(Place(1, -1, 1));
    }

    Place operator()(const Points& points, Index row) const {
        return (*this)(points.row(row).transpose());
    }

    /// A direction, in pixels.
    Place along(const Place& vector) const {
        return (scale_ * (axes_ * vector)).cwiseProduct(Place(1, -1, 1));
    }

private:
    Eigen::Matrix3d axes_; ///< to the right, up and to the eye, as rows
    Place middle_, center_;
    double scale_;
};

} // namespace polydec
