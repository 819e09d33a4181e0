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
    std::optional<int> exponent = {}; ///< raised behind the text
    double turned = 0;                ///< degrees, clockwise
};

/// SVG elements in pixels, y down, one after the other on white ground.
class SvgCanvas {
public:
    SvgCanvas(double width, double height);

    void polyline(const std::vector<SvgPoint>& points, const SvgStyle& style);
    void polygon(const std::vector<SvgPoint>& points, const SvgStyle& style);
    void circle(SvgPoint center, double radius, const SvgStyle& style);
    void text(SvgPoint at, std::string_view text, const SvgLabel& label = {});

    /// What is drawn from here on, until the next opening or closing, belongs to a group with this
    /// name, which viewers show as a tooltip.
    void open_group(std::string_view name);
    void close_group();

    /// The whole file. Nothing may be added afterwards.
    std::string finish();

private:
    std::string text_;
};

/// About how wide a text is in the common sans-serif fonts, pixels.
double svg_text_width(std::string_view text, double size);

} // namespace polydec
