// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace polydec {

/// How an axis runs.
enum class Scale { logarithmic, linear };

struct SvgAxis {
    std::string label;
    Scale scale = Scale::logarithmic;
};

/// What is drawn of a series.
enum class SvgTrace { line_and_markers, line, markers };

/// Points (x[i], y[i]) in the order of the line through them. Where a number is NaN there is no
/// point, and the line goes on from the one before to the next.
struct SvgSeries {
    std::string name; ///< in the legend
    std::vector<double> x, y;
    SvgTrace trace = SvgTrace::line_and_markers;
};

/// A right triangle whose long side has this slope, beside the lower end of a series: the order of
/// convergence to compare it with.
struct SvgSlope {
    double slope;
    std::size_t series = 0;
};

/// A plot of series over two axes.
struct SvgPlot {
    std::string title;
    SvgAxis x, y;
    std::vector<SvgSeries> series = {};
    std::vector<SvgSlope> slopes = {}; ///< both axes must be logarithmic where there are any
    double width = 720, height = 520;  ///< of the file, pixels
};

/// The plot as an SVG file on white ground. Colors (Okabe and Ito's, which the color-blind can
/// tell apart), markers and dashes are chosen by the number of the series; ticks stand at decades
/// or at round numbers; the legend in a corner that is free of data, or else at the right.
/// Throws InvalidInput, naming the series, if there is none, if one has as many x as y not, has no
/// points, or has a number that is infinite, or not positive on a logarithmic axis; and for slopes
/// without logarithmic axes or of a series that there is not.
std::string to_svg(const SvgPlot& plot);

} // namespace polydec
