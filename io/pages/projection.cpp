// SPDX-License-Identifier: MIT
#include "io/pages/projection.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace polydec {

Projection::Projection(const SolidView& view, const Points& points,
                       const std::vector<Index>& numbers, const SvgBox& frame) {
    const Place eye = Place(view.eye).normalized();
    const Place right = Place(view.up).cross(eye).normalized();
    axes_ << right.transpose(), eye.cross(right).transpose(), eye.transpose();
    Place low = Place::Zero(), high = low;
    if (!numbers.empty())
        low = high = axes_ * Place(points.row(numbers.front()));
    for (const Index v : numbers) {
        const Place p = axes_ * Place(points.row(v));
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const Place size = high - low;
    scale_ = std::min(frame.width() / size[0], frame.height() / size[1]);
    if (!std::isfinite(scale_))
        scale_ = 1;
    middle_ = low / 2 + high / 2;
    center_ = {(frame.left + frame.right) / 2, (frame.top + frame.bottom) / 2, 0};
}

} // namespace polydec
