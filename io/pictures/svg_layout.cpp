// SPDX-License-Identifier: MIT
#include "io/pictures/svg_layout.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polydec {

SvgExtent extent_of_polygons(const SvgDrawing& drawing) {
    SvgExtent extent;
    for (const auto& shape : drawing.shapes)
        for (const auto& point : std::get<SvgPolygon>(shape).points)
            extent.add(point);
    return extent;
}

std::size_t meetings(const SvgObstacles& obstacles, const SvgBox& box) {
    return std::count_if(obstacles.begin(), obstacles.end(),
                         [&](const SvgBox& obstacle) { return obstacle.meets(box); });
}

bool covers(const std::vector<SvgPoint>& polygon, SvgPoint point) {
    bool inside = false; // by the parity of the edges to its right
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const auto& [ax, ay] = polygon[i];
        const auto& [bx, by] = polygon[(i + 1) % polygon.size()];
        if ((ay > point[1]) != (by > point[1]) &&
            point[0] < ax + (bx - ax) * (point[1] - ay) / (by - ay))
            inside = !inside;
    }
    return inside;
}

SvgPoint free_center(const std::vector<SvgPoint>& wishes, double width, double height,
                     const SvgObstacles& obstacles) {
    const auto is_free = [&](SvgPoint place) {
        return meetings(obstacles, box_around(place, width, height)) == 0;
    };
    const auto found = std::find_if(wishes.begin(), wishes.end(), is_free);
    if (found != wishes.end())
        return *found;
    for (int ring = 1;; ++ring)
        for (int i = 0; i < 8 * ring; ++i) {
            const double angle = 2 * std::numbers::pi * i / (8 * ring);
            const SvgPoint place{wishes.front()[0] + ring * height / 2 * std::cos(angle),
                                 wishes.front()[1] + ring * height / 2 * std::sin(angle)};
            if (is_free(place))
                return place;
        }
}

} // namespace polydec
