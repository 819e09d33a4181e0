// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace polydec {

/// Scale of an axis.
enum class Scale { logarithmic, linear };

struct SvgAxis {
    std::string label;
    Scale scale = Scale::logarithmic;
};

/// How a series is drawn.
enum class SvgTrace { line_and_markers, line, markers };

/// Points (x[i], y[i]) in the order of the line through them. NaN omits a point; the line then
/// connects its neighbors.
struct SvgSeries {
    std::string name; ///< in the legend
    std::vector<double> x, y;
    SvgTrace trace = SvgTrace::line_and_markers;
};

/// A right triangle beside the lower end of a series. The slope of its long side is a reference
/// order of convergence.
struct SvgSlope {
    double slope;
    std::size_t series = 0;
};

/// A plot of series over two axes.
struct SvgPlot {
    std::string title;
    SvgAxis x, y;
    std::vector<SvgSeries> series = {};
    std::vector<SvgSlope> slopes = {}; ///< need two logarithmic axes
    double width = 720, height = 520;  ///< of the file, pixels
};

/// The plot as an SVG file on a white background. The index of a series gives its color (Okabe and
/// Ito's palette, safe for color-blind readers), marker and dashes. Ticks are at decades or round
/// numbers. The legend is in a corner free of data, or else at the right. Throws InvalidInput,
/// naming the series, without series or points, for x and y of different length, and for numbers
/// that are infinite, or not positive on a logarithmic axis. Also for slopes without logarithmic
/// axes or for a missing series.
std::string to_svg(const SvgPlot& plot);

} // namespace polydec
