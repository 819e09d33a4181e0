// SPDX-License-Identifier: MIT
#include "io/pages/surface_painter.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace polydec {

namespace {

constexpr float nothing = -std::numeric_limits<float>::infinity();
constexpr double near_enough = 4; ///< pixels

/// The color of the line at a place with these distances from the sides, if one is there.
const Color* line_at(const SeenTriangle& triangle, const Eigen::Vector3d& distances) {
    for (int side = 0; side < 3; ++side) {
        const auto& line = triangle.sides[side];
        if (line && distances[(side + 2) % 3] < triangle.side_width)
            return &*line;
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
      nearness_(static_cast<std::size_t>(samples_.width()) *
                    static_cast<std::size_t>(samples_.height()),
                nothing) {}

Color SurfacePainter::color(double part) const {
    if (map_.empty())
        return plain_;
    const double at = std::clamp(part, 0.0, 1.0) * static_cast<double>(map_.size() - 1);
    return map_[static_cast<std::size_t>(std::lround(at))];
}

Color SurfacePainter::color(const SeenTriangle& triangle, const Eigen::Vector3d& weights) const {
    Color result = plain_;
    if (triangle.parts)
        result = color(weights.dot(Eigen::Vector3d(triangle.parts->data())));
    return darker(result, triangle.brightness);
}

void SurfacePainter::paint(const SeenTriangle& triangle) {
    Eigen::Matrix3d p; // a column for each corner, in samples
    for (int i = 0; i < 3; ++i)
        p.col(i) = factor * triangle.corners[i];
    const auto cross = [](double ax, double ay, double bx, double by) { return ax * by - ay * bx; };
    const double area =
        cross(p(0, 1) - p(0, 0), p(1, 1) - p(1, 0), p(0, 2) - p(0, 0), p(1, 2) - p(1, 0));
    if (area == 0 || !std::isfinite(area))
        return; // seen from its side

    Eigen::Vector3d heights; // over the sides opposite to the corners, in pixels
    for (int i = 0; i < 3; ++i)
        heights[i] =
            std::abs(area) / (p.col((i + 1) % 3) - p.col((i + 2) % 3)).head(2).norm() / factor;
    const auto bound = [](double place, int end) {
        return static_cast<int>(std::clamp(std::ceil(place - 0.5), 0.0, static_cast<double>(end)));
    };
    const int left = bound(p.row(0).minCoeff(), samples_.width());
    const int right = bound(p.row(0).maxCoeff() + 1, samples_.width());
    const int top = bound(p.row(1).minCoeff(), samples_.height());
    const int bottom = bound(p.row(1).maxCoeff() + 1, samples_.height());
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) {
            Eigen::Vector3d weights;
            for (int i = 0; i < 3; ++i) {
                const auto a = p.col((i + 1) % 3), b = p.col((i + 2) % 3);
                weights[i] =
                    cross(a[0] - x - 0.5, a[1] - y - 0.5, b[0] - x - 0.5, b[1] - y - 0.5) / area;
            }
            if (weights.minCoeff() < 0)
                continue;
            const auto nearness = static_cast<float>(p.row(2).dot(weights));
            float& known =
                nearness_[static_cast<std::size_t>(y) * static_cast<std::size_t>(samples_.width()) +
                          static_cast<std::size_t>(x)];
            if (nearness <= known)
                continue;
            known = nearness;
            const Color* line = line_at(triangle, weights.cwiseProduct(heights));
            samples_.set(x, y, line != nullptr ? *line : color(triangle, weights));
        }
}

bool SurfacePainter::shows(const Eigen::Vector3d& point) const {
    const double x = factor * point[0], y = factor * point[1];
    if (!(x >= 0 && y >= 0 && x < samples_.width() && y < samples_.height()))
        return false;
    const float known =
        nearness_[static_cast<std::size_t>(y) * static_cast<std::size_t>(samples_.width()) +
                  static_cast<std::size_t>(x)];
    return known != nothing && known <= factor * (point[2] + near_enough);
}

} // namespace polydec
