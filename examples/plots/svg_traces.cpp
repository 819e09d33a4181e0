// SPDX-License-Identifier: MIT
#include "examples/plots/svg_traces.h"

#include <array>
#include <cmath>
#include <numbers>

namespace polydec {

namespace {

constexpr std::array colors{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                            "#E69F00", "#56B4E9", "#000000"};
constexpr double radius = 4.5;

std::vector<double> dashes(std::size_t series) {
    static const std::array<std::vector<double>, 4> patterns{{{}, {8, 4}, {2, 3}, {9, 3, 2, 3}}};
    return patterns[series % patterns.size()];
}

/// A regular polygon around a point, its first corner at this angle, degrees counterclockwise.
std::vector<SvgPoint> regular(SvgPoint center, int corners, double first, double size) {
    std::vector<SvgPoint> points;
    for (int i = 0; i < corners; ++i) {
        const double angle = (first + 360.0 * i / corners) * std::numbers::pi / 180;
        points.push_back({center[0] + size * std::cos(angle), center[1] - size * std::sin(angle)});
    }
    return points;
}

void draw_marker(SvgCanvas& canvas, std::size_t series, SvgPoint at) {
    const SvgStyle solid{.stroke = "#ffffff", .fill = trace_color(series), .width = 0.8};
    const SvgStyle line{.stroke = trace_color(series), .width = 2};
    const auto [x, y] = at;
    // a series with a repeated color has another marker
    switch ((series + series / colors.size()) % 7) {
    case 0:
        return canvas.circle(at, radius, solid);
    case 1:
        return canvas.polygon(regular(at, 4, 45, 1.25 * radius), solid);
    case 2:
        return canvas.polygon(regular(at, 3, 90, 1.3 * radius), solid);
    case 3:
        return canvas.polygon(regular(at, 4, 0, 1.35 * radius), solid);
    case 4:
        return canvas.polygon(regular(at, 3, -90, 1.3 * radius), solid);
    case 5:
        canvas.polyline({{x - 3.5, y - 3.5}, {x + 3.5, y + 3.5}}, line);
        return canvas.polyline({{x - 3.5, y + 3.5}, {x + 3.5, y - 3.5}}, line);
    default:
        canvas.polyline({{x - 4.5, y}, {x + 4.5, y}}, line);
        return canvas.polyline({{x, y - 4.5}, {x, y + 4.5}}, line);
    }
}

} // namespace

const char* trace_color(std::size_t series) {
    return colors[series % colors.size()];
}

void draw_trace(SvgCanvas& canvas, std::size_t series, SvgTrace trace,
                const std::vector<SvgPoint>& points) {
    if (trace != SvgTrace::markers && points.size() > 1)
        canvas.polyline(points,
                        {.stroke = trace_color(series), .width = 1.8, .dashes = dashes(series)});
    if (trace != SvgTrace::line)
        for (const auto& point : points)
            draw_marker(canvas, series, point);
}

void draw_trace_sample(SvgCanvas& canvas, std::size_t series, SvgTrace trace, SvgPoint left,
                       double width) {
    if (trace != SvgTrace::markers)
        draw_trace(canvas, series, SvgTrace::line, {left, {left[0] + width, left[1]}});
    if (trace != SvgTrace::line)
        draw_marker(canvas, series, {left[0] + width / 2, left[1]});
}

} // namespace polydec
