// SPDX-License-Identifier: MIT
#include "io/pages/surface_painter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polydec {

namespace {

constexpr float nothing = -std::numeric_limits<float>::infinity();
constexpr double near_enough = 4; ///< pixels

/// A number for each place, linear in both coordinates.
struct Linear {
    double constant = 0, per_x = 0, per_y = 0;

    double operator()(double x, double y) const { return constant + per_x * x + per_y * y; }
};

double mean(const SurfacePainter::Weights& values, const double (&weights)[3]) {
    return values[0] * weights[0] + values[1] * weights[1] + values[2] * weights[2];
}

/// The coordinate opposite to a side of a triangle. The neighbor there computes the same numbers
/// with the other sign, so that no sample between them is left out.
Linear barycentric(double x, double y, double next_x, double next_y, double area) {
    return {(x * next_y - y * next_x) / area, (y - next_y) / area, (next_x - x) / area};
}

/// The values of the corners at each place, from the barycentric coordinates there.
Linear mean(const SurfacePainter::Weights& values, const Linear (&weights)[3]) {
    const auto& [a, b, c] = weights;
    return {mean(values, {a.constant, b.constant, c.constant}),
            mean(values, {a.per_x, b.per_x, c.per_x}), mean(values, {a.per_y, b.per_y, c.per_y})};
}

/// The color of the line at a place of a triangle of these heights, if one is there.
const Color* line_at(const SeenTriangle& triangle, const SurfacePainter::Weights& weights,
                     const SurfacePainter::Weights& heights) {
    for (std::size_t side = 0; side < 3; ++side) {
        const std::size_t opposite = (side + 2) % 3;
        if (triangle.sides[side] && weights[opposite] * heights[opposite] < triangle.side_width)
            return &*triangle.sides[side];
    }
    return nullptr;
}

} // namespace

std::vector<Color> fine_map(ColorMap map) {
    constexpr int size = 1025;
    std::vector<Color> colors;
    for (int i = 0; i < size; ++i)
        colors.push_back(color_of(color_at(map, static_cast<double>(i) / (size - 1))));
    return colors;
}

SurfacePainter::SurfacePainter(int width, int height, std::vector<Color> map, Color plain)
    : map_(std::move(map)),
      plain_(plain),
      samples_(factor * width, factor * height),
      nearness_(samples_.place(0, samples_.height()), nothing) {}

Color SurfacePainter::color(double part) const {
    if (map_.empty())
        return plain_;
    const double at = std::clamp(part, 0.0, 1.0) * static_cast<double>(map_.size() - 1);
    return map_[std::lround(at)];
}

Color SurfacePainter::shaded(const SeenTriangle& triangle, double part) const {
    return darker(triangle.parts ? color(part) : plain_, triangle.brightness);
}

Color SurfacePainter::color(const SeenTriangle& triangle, const Weights& weights) const {
    return shaded(triangle,
                  triangle.parts ? mean(*triangle.parts, {weights[0], weights[1], weights[2]}) : 0);
}

void SurfacePainter::paint(const SeenTriangle& triangle) {
    Weights x, y, nearness; // of the corners, in samples
    for (std::size_t i = 0; i < 3; ++i) {
        x[i] = factor * triangle.corners[i][0];
        y[i] = factor * triangle.corners[i][1];
        nearness[i] = factor * triangle.corners[i][2];
    }
    const double area = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
    if (area == 0 || !std::isfinite(area))
        return; // seen from its side

    Linear weights[3];
    Weights heights; // over the opposite sides, in pixels
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t a = (i + 1) % 3, b = (i + 2) % 3;
        weights[i] = barycentric(x[a], y[a], x[b], y[b], area);
        heights[i] = std::abs(area) / std::hypot(x[a] - x[b], y[a] - y[b]) / factor;
    }
    const Linear near = mean(nearness, weights);
    const Linear part = triangle.parts ? mean(*triangle.parts, weights) : Linear{};
    const bool has_lines = triangle.sides[0] || triangle.sides[1] || triangle.sides[2];
    const auto bound = [](double place, int end) {
        return static_cast<int>(std::clamp(std::ceil(place - 0.5), 0.0, static_cast<double>(end)));
    };
    const auto [left, right] = std::minmax({x[0], x[1], x[2]});
    const auto [top, bottom] = std::minmax({y[0], y[1], y[2]});
    const int first = bound(left, samples_.width()), end = bound(right + 1, samples_.width());
    const int y_end = bound(bottom + 1, samples_.height());
    for (int row = bound(top, samples_.height()); row < y_end; ++row)
        for (int column = first; column < end; ++column) {
            const double at_x = column + 0.5, at_y = row + 0.5;
            const double a = weights[0](at_x, at_y), b = weights[1](at_x, at_y),
                         c = weights[2](at_x, at_y);
            if (a < 0 || b < 0 || c < 0)
                continue;
            const auto nearer = static_cast<float>(near(at_x, at_y));
            float& known = nearness_[samples_.place(column, row)];
            if (nearer <= known)
                continue;
            known = nearer;
            const Color* line = has_lines ? line_at(triangle, {a, b, c}, heights) : nullptr;
            samples_.set(column, row, line != nullptr ? *line : shaded(triangle, part(at_x, at_y)));
        }
}

bool SurfacePainter::shows(const Eigen::Vector3d& point) const {
    const double x = factor * point[0], y = factor * point[1];
    if (!(x >= 0 && y >= 0 && x < samples_.width() && y < samples_.height()))
        return false;
    const float known = nearness_[samples_.place(static_cast<int>(x), static_cast<int>(y))];
    return known != nothing && known <= factor * (point[2] + near_enough);
}

} // namespace polydec
