// SPDX-License-Identifier: MIT
#pragma once

#include "examples/plots/svg_plot.h"
#include "io/pictures/svg_canvas.h"

namespace polydec {

/// The color of a series by its index: colors of Okabe and Ito that are visible on white.
const char* trace_color(std::size_t series);

/// Draws a series at these pixels: line, markers or both, with its color, marker and dashes.
void draw_trace(SvgCanvas& canvas, std::size_t series, SvgTrace trace,
                const std::vector<SvgPoint>& points);

/// The short line with one marker in the legend.
void draw_trace_sample(SvgCanvas& canvas, std::size_t series, SvgTrace trace, SvgPoint left,
                       double width);

} // namespace polydec
