// SPDX-License-Identifier: MIT
#pragma once

#include "io/pictures/svg_layout.h"

#include <optional>
#include <vector>

namespace polydec {

/// Adds small boxes along the line through these points.
void add_line(SvgObstacles& obstacles, const std::vector<SvgPoint>& points);

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

} // namespace polydec
