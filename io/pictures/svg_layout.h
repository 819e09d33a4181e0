// SPDX-License-Identifier: MIT
#pragma once

#include "io/pictures/svg_canvas.h"

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

/// What is in the way of triangles and legends: small boxes along lines, and whole ones.
using SvgObstacles = std::vector<SvgBox>;

void add_line(SvgObstacles& obstacles, const std::vector<SvgPoint>& points);

/// How much of a box is in the way: the number of obstacles it meets.
std::size_t meetings(const SvgObstacles& obstacles, const SvgBox& box);

/// A right triangle beside a line: the long side from first to second, and where both legs meet.
struct SvgSlopeTriangle {
    SvgPoint first, second, corner;

    /// What it covers: strips between the long side and a leg, and room for the numbers at the
    /// legs.
    std::vector<SvgBox> boxes() const;
};

/// A triangle whose long side rises `rise` pixels over `width`, beside the lower end of the line
/// through these points; where it meets no obstacle within the frame, or else as few as can be.
SvgSlopeTriangle place_triangle(const std::vector<SvgPoint>& line, double width, double rise,
                                const SvgObstacles& obstacles, const SvgBox& frame);

/// A box of this size in a corner of the frame that no obstacle meets, if there is one.
std::optional<SvgBox> free_corner(double width, double height, const SvgObstacles& obstacles,
                                  const SvgBox& frame);

} // namespace polydec
