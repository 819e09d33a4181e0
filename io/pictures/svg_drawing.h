// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace polydec {

/// A point in a drawing, in world coordinates: x to the right, y up.
using SvgPoint = std::array<double, 2>;

/// The style of the line and the inside of a shape.
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

/// A circle in world coordinates, such as a circumcircle.
struct SvgCircle {
    SvgPoint center;
    double radius; ///< world coordinates
    SvgStyle style = {};
};

/// A mark at a point, of fixed size in pixels.
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

/// A line of text with its baseline at the point.
struct SvgText {
    SvgPoint at;
    std::string text;
    double size = 14; ///< pixels
    SvgAnchor anchor = SvgAnchor::middle;
    std::string color = "#000000";
};

using SvgShape = std::variant<SvgPolyline, SvgPolygon, SvgCircle, SvgDot, SvgArrow, SvgText>;

/// A list of shapes, drawn in order.
struct SvgDrawing {
    std::string title = {}; ///< above the shapes; empty: none
    std::vector<SvgShape> shapes = {};
    double width = 720; ///< of the file, pixels
    double margin = 16; ///< around the shapes, pixels
};

/// The drawing as an SVG file on white background. Shapes are scaled equally in x and y; they fill
/// the width, or are centered if more than twice as high. Text, dots and lines enter the extent by
/// their points alone; the margin must hold the rest. Throws InvalidInput, naming the shape, if
/// there is none, if one has no points, if a coordinate or radius is not finite, if all lie at one
/// point, or if the margins leave no room.
std::string to_svg(const SvgDrawing& drawing);

/// Combines drawings in a row, each at its own size, with their centers at one height and their
/// titles above at another. Throws InvalidInput if there is none, and like to_svg.
SvgDrawing side_by_side(const std::vector<SvgDrawing>& drawings);

/// Writes the text of an SVG file as .svg, or as .png or .pdf by the program rsvg-convert or
/// cairosvg, the first on PATH; a PNG has two pixels for each of the drawing. The file appears
/// whole or not at all. Throws InvalidInput for another extension; BackendUnavailable if neither
/// program is there; SolverFailure, with its last words, if it fails; and like AtomicFile.
void write_drawing(const std::filesystem::path& path, std::string_view svg);
void write_drawing(const std::filesystem::path& path, const SvgDrawing& drawing);

/// Throws like write_drawing for the extension and the programs, before any work is done.
void check_drawing_file(const std::filesystem::path& path);

} // namespace polydec
