// SPDX-License-Identifier: MIT
#include "examples/plots/plot_layout.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polydec {

namespace {

constexpr double reach = 6;                       // of a marker around its point
constexpr double step = 4;                        // between the boxes along a line
constexpr double inset = 8;                       // of a legend from the frame
constexpr double beside_leg = 30, under_leg = 18; // room for numbers

/// Points along a line, the ends of its pieces included.
std::vector<SvgPoint> samples(const std::vector<SvgPoint>& points) {
    std::vector<SvgPoint> result;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const auto [x, y] = points[i];
        const double dx = points[i + 1][0] - x, dy = points[i + 1][1] - y;
        const int parts = 1 + static_cast<int>(std::hypot(dx, dy) / step);
        for (int j = 0; j < parts; ++j)
            result.push_back({x + dx * j / parts, y + dy * j / parts});
    }
    result.push_back(points.back());
    return result;
}

enum class TriangleSide { below, above };

/// The triangle on this side of its long side, whose middle is given.
SvgSlopeTriangle triangle_at(SvgPoint middle, double width, double rise, TriangleSide side) {
    const SvgPoint first{middle[0] - width / 2, middle[1] + rise / 2};
    const SvgPoint second{middle[0] + width / 2, middle[1] - rise / 2};
    const bool ascending = rise > 0;
    const SvgPoint& high = ascending ? second : first;
    const SvgPoint& low = ascending ? first : second;
    if (side == TriangleSide::below)
        return {first, second, {high[0], low[1]}};
    return {first, second, {low[0], high[1]}};
}

} // namespace

void add_line(SvgObstacles& obstacles, const std::vector<SvgPoint>& points) {
    for (const auto& [x, y] : samples(points))
        obstacles.push_back(SvgBox{x, y, x, y}.grown(reach));
}

std::vector<SvgBox> SvgSlopeTriangle::boxes() const {
    constexpr int strips = 8;
    std::vector<SvgBox> result;
    for (int i = 0; i < strips; ++i) {
        const auto x = [&](int j) { return first[0] + (second[0] - first[0]) * j / strips; };
        const auto y = [&](int j) { return first[1] + (second[1] - first[1]) * j / strips; };
        result.push_back({x(i), std::min({y(i), y(i + 1), corner[1]}), x(i + 1),
                          std::max({y(i), y(i + 1), corner[1]})});
    }
    const double x = (first[0] + second[0]) / 2, y = (first[1] + second[1]) / 2;
    const bool right = corner[0] > x, below = corner[1] > y;
    result.push_back({right ? corner[0] : corner[0] - beside_leg, y - 10,
                      right ? corner[0] + beside_leg : corner[0], y + 10});
    result.push_back({x - 8, below ? corner[1] : corner[1] - under_leg, x + 8,
                      below ? corner[1] + under_leg : corner[1]});
    return result;
}

SvgSlopeTriangle place_triangle(const std::vector<SvgPoint>& line, double width, double rise,
                                const SvgObstacles& obstacles, const SvgBox& frame) {
    auto places = samples(line);
    // y points down, so the lower end has the larger one
    if (places.front()[1] < places.back()[1])
        std::reverse(places.begin(), places.end());
    const double length = std::hypot(width, rise);

    SvgSlopeTriangle best{};
    auto fewest = std::numeric_limits<std::size_t>::max();
    for (const double gap : {14.0, 24.0, 36.0, 50.0})
        for (const auto& [x, y] : places)
            for (const TriangleSide side : {TriangleSide::below, TriangleSide::above}) {
                const double away = side == TriangleSide::below ? gap : -gap;
                const SvgPoint middle{x + away * rise / length, y + away * width / length};
                const auto triangle = triangle_at(middle, width, rise, side);
                const auto boxes = triangle.boxes();
                if (!std::all_of(boxes.begin(), boxes.end(),
                                 [&](const SvgBox& box) { return frame.holds(box); }))
                    continue;
                std::size_t found = 0;
                for (const auto& box : boxes)
                    found += meetings(obstacles, box);
                if (found < fewest) {
                    fewest = found;
                    best = triangle;
                }
                if (fewest == 0)
                    return best;
            }
    if (fewest == std::numeric_limits<std::size_t>::max())
        best = triangle_at({frame.left + frame.width() / 2, frame.top + frame.height() / 2}, width,
                           rise, TriangleSide::below);
    return best;
}

std::optional<SvgBox> free_corner(double width, double height, const SvgObstacles& obstacles,
                                  const SvgBox& frame) {
    const double left = frame.left + inset, right = frame.right - inset - width;
    const double top = frame.top + inset, bottom = frame.bottom - inset - height;
    if (right < left || bottom < top)
        return std::nullopt;
    for (const auto& [x, y] : {SvgPoint{left, top}, SvgPoint{right, bottom}, SvgPoint{right, top},
                               SvgPoint{left, bottom}}) {
        const SvgBox box{x, y, x + width, y + height};
        if (meetings(obstacles, box) == 0)
            return box;
    }
    return std::nullopt;
}

} // namespace polydec
