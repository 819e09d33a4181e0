// SPDX-License-Identifier: MIT
#pragma once

#include "io/pictures/svg_canvas.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace polydec {

/// A rectangle of pixels, y down.
struct SvgBox {
    double left, top, right, bottom;

    double width() const { return right - left; }
    double height() const { return bottom - top; }
    SvgBox grown(double by) const { return {left - by, top - by, right + by, bottom + by}; }
    bool holds(const SvgBox& other) const {
        return left <= other.left && top <= other.top && right >= other.right &&
               bottom >= other.bottom;
    }
    bool meets(const SvgBox& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

/// How far points reach in both directions.
struct SvgExtent {
    static constexpr double most = std::numeric_limits<double>::infinity();
    SvgPoint low{most, most}, high{-most, -most};

    void add(const SvgPoint& point, double around = 0) {
        for (int axis = 0; axis < 2; ++axis) {
            low[axis] = std::min(low[axis], point[axis] - around);
            high[axis] = std::max(high[axis], point[axis] + around);
        }
    }
    double size(int axis) const { return high[axis] - low[axis]; }
};

/// That of a drawing that has polygons alone.
SvgExtent extent_of_polygons(const SvgDrawing& drawing);

/// Boxes that others must not meet.
using SvgObstacles = std::vector<SvgBox>;

/// The number of obstacles that meet a box.
std::size_t meetings(const SvgObstacles& obstacles, const SvgBox& box);

/// The center of a box of this size that meets no obstacle: the first free one of the wishes, or
/// else the first free place on growing circles around the first wish.
SvgPoint free_center(const std::vector<SvgPoint>& wishes, double width, double height,
                     const SvgObstacles& obstacles);

/// Whether a polygon has a point in its inside.
bool covers(const std::vector<SvgPoint>& polygon, SvgPoint point);

/// The box of this size around a point.
inline SvgBox box_around(SvgPoint center, double width, double height) {
    return {center[0] - width / 2, center[1] - height / 2, center[0] + width / 2,
            center[1] + height / 2};
}

} // namespace polydec
