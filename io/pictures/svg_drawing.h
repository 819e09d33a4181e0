// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

namespace polydec {

/// A place in a drawing, in world coordinates: x to the right, y up.
using SvgPoint = std::array<double, 2>;

/// How the line of a shape and what it encloses are painted.
struct SvgStyle {
    std::string stroke = "#000000";  ///< color of the line; none: no line
    std::string fill = "none";       ///< color of the inside; none: nothing
    double width = 1;                ///< of the line, pixels
    std::vector<double> dashes = {}; ///< lengths of dashes and gaps in turn, pixels; none: unbroken
    double opacity = 1;              ///< of the inside, 0 to 1
};

/// A line through points, not closed.
struct SvgPolyline {
    std::vector<SvgPoint> points;
    SvgStyle style = {};
};

/// A closed line and its inside.
struct SvgPolygon {
    std::vector<SvgPoint> points;
    SvgStyle style = {};
};

/// A circle of the world, such as a circumcircle.
struct SvgCircle {
    SvgPoint center;
    double radius; ///< world coordinates
    SvgStyle style = {};
};

/// A mark at a point, which is as large in every drawing.
struct SvgDot {
    SvgPoint center;
    double radius = 3; ///< pixels
    SvgStyle style = {.stroke = "none", .fill = "#000000"};
};

/// A straight line with a head at its end.
struct SvgArrow {
    SvgPoint from, to;
    SvgStyle style = {};
};

enum class SvgAnchor { start, middle, end };

/// A line of text, on whose baseline the point lies.
struct SvgText {
    SvgPoint at;
    std::string text;
    double size = 14; ///< pixels
    SvgAnchor anchor = SvgAnchor::middle;
    std::string color = "#000000";
};

using SvgShape = std::variant<SvgPolyline, SvgPolygon, SvgCircle, SvgDot, SvgArrow, SvgText>;

/// A list of shapes, each of which lies over those before it.
struct SvgDrawing {
    std::string title = {}; ///< above the shapes; empty: none
    std::vector<SvgShape> shapes = {};
    double width = 720; ///< of the file, pixels
    double margin = 16; ///< around the shapes, pixels
};

/// The drawing as an SVG file on white ground: the shapes are scaled alike in x and y and fill the
/// width, or stand in its middle if they are more than twice as high. Of text, dots and lines the
/// points alone count in the extent; what reaches further needs a margin.
/// Throws InvalidInput, naming the shape, if there is none, if one has no points, a coordinate or
/// radius that is not finite, if all lie at one point, or if the margins leave no room.
std::string to_svg(const SvgDrawing& drawing);

/// One drawing of several in a row, each as large as it is alone: their middles are at one height,
/// their titles above at another. Throws InvalidInput if there is none, and like to_svg.
SvgDrawing side_by_side(const std::vector<SvgDrawing>& drawings);

} // namespace polydec
