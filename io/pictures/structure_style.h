// SPDX-License-Identifier: MIT
#pragma once

#include "io/pictures/svg_drawing.h"

#include <array>
#include <string>
#include <vector>

namespace polydec {

/// Styles of annotated drawings, in colors that are safe for color blindness.
inline constexpr const char* edge_color = "#222222";
inline constexpr const char* turn_color = "#6F4E9C";
inline constexpr const char* number_color = "#B34700";
inline constexpr const char* cell_color = "#E4E9EF";

/// The colors of the numbers of vertices, edges, 2-cells and 3-cells.
inline constexpr std::array number_colors{edge_color, number_color, turn_color, "#00694B"};

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
/// Edges that are the cells of a chain, and the band of a dual cell beneath them.
inline SvgStyle chain_style() {
    return {.stroke = "#9AA7B5", .width = 5};
}
inline SvgStyle band_style() {
    return {.stroke = "#F2D28B", .width = 16};
}
/// A dual cell on a surface.
inline SvgStyle fill_style() {
    return {.stroke = "none", .fill = "#F0B429", .opacity = 0.5};
}

/// The meaning of a line style.
struct LineInWords {
    SvgStyle style;
    std::string words;
};

/// Pixels that these rows of a legend take below a drawing.
double height_of_lines(std::size_t rows);

/// Adds one legend row per line below a drawing with this lower left corner; `pixel` is in world
/// units.
void tell_lines(SvgDrawing& drawing, const std::vector<LineInWords>& lines, SvgPoint corner,
                double pixel);

} // namespace polydec
