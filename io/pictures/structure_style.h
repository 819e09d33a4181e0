// SPDX-License-Identifier: MIT
#pragma once

#include "io/pictures/svg_drawing.h"

#include <string>
#include <vector>

namespace polydec {

/// Styles of annotated drawings, in colors that are safe for color blindness.
inline constexpr const char* edge_color = "#222222";
inline constexpr const char* turn_color = "#6F4E9C";
inline constexpr const char* number_color = "#B34700";

inline SvgStyle edge_style() {
    return {.stroke = edge_color, .width = 1.4};
}
inline SvgStyle removed_style() {
    return {.stroke = "#D55E00", .width = 1.4, .dashes = {5, 4}};
}
inline SvgStyle dual_style() {
    return {.stroke = "#0072B2", .width = 1.8};
}
inline SvgStyle negative_style() {
    return {.stroke = "#C2185B", .width = 1.8};
}
inline SvgStyle circle_style() {
    return {.stroke = "#009E73", .width = 1, .dashes = {2, 3}};
}
inline SvgStyle turn_style() {
    return {.stroke = turn_color, .width = 1.3};
}

/// The meaning of a line style.
struct LineInWords {
    SvgStyle style;
    std::string words;
};

/// Adds one legend row per line below a drawing with this lower left corner; `pixel` is in world
/// units.
void tell_lines(SvgDrawing& drawing, const std::vector<LineInWords>& lines, SvgPoint corner,
                double pixel);

} // namespace polydec
