// SPDX-License-Identifier: MIT
#pragma once

#include "io/pictures/svg_canvas.h"

#include <algorithm>
#include <limits>
#include <optional>
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

/// Obstacles for triangles and legends: small boxes along lines, and larger boxes.
using SvgObstacles = std::vector<SvgBox>;

void add_line(SvgObstacles& obstacles, const std::vector<SvgPoint>& points);

/// The number of obstacles that meet a box.
std::size_t meetings(const SvgObstacles& obstacles, const SvgBox& box);

/// A right triangle beside a line: hypotenuse from first to second, right angle at corner.
struct SvgSlopeTriangle {
    SvgPoint first, second, corner;

    /// The area it covers: strips between the hypotenuse and a leg, and room for the numbers at the
    /// legs.
    std::vector<SvgBox> boxes() const;
};

/// A triangle whose hypotenuse rises `rise` pixels over `width`, beside the lower end of the line
/// through these points. It meets as few obstacles as possible, within the frame.
SvgSlopeTriangle place_triangle(const std::vector<SvgPoint>& line, double width, double rise,
                                const SvgObstacles& obstacles, const SvgBox& frame);

/// A box of this size in a corner of the frame that meets no obstacle, if there is one.
std::optional<SvgBox> free_corner(double width, double height, const SvgObstacles& obstacles,
                                  const SvgBox& frame);

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
