// SPDX-License-Identifier: MIT
#pragma once

#include "io/pictures/svg_drawing.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polydec {

/// A line of text on a canvas.
struct SvgLabel {
    double size = 14;
    SvgAnchor anchor = SvgAnchor::middle;
    std::string color = "#000000";
    std::optional<int> exponent = {}; ///< superscript after the text
    double turned = 0;                ///< degrees, clockwise
};

/// SVG elements in pixels, y down, in order, on a white background.
class SvgCanvas {
public:
    SvgCanvas(double width, double height);

    void polyline(const std::vector<SvgPoint>& points, const SvgStyle& style);
    void polygon(const std::vector<SvgPoint>& points, const SvgStyle& style);
    void circle(SvgPoint center, double radius, const SvgStyle& style);
    void image(SvgPoint left_top, double width, double height, std::string_view png);
    void text(SvgPoint at, std::string_view text, const SvgLabel& label = {});
    void draw(const SvgShape& shape);

    /// Elements from here to the next open or close form a group with this name, which viewers show
    /// as a tooltip.
    void open_group(std::string_view name);
    void close_group();

    /// The whole file. Nothing may be added afterwards.
    std::string finish();

private:
    std::string text_;
};

/// Approximate width of a text in common sans-serif fonts, in pixels.
double svg_text_width(std::string_view text, double size);

/// The text, without its end if it is longer than this many pixels.
std::string svg_shortened(const std::string& text, double size, double most);

} // namespace polydec
