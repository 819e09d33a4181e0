// SPDX-License-Identifier: MIT
#pragma once

#include "io/pictures/color_map.h"
#include "io/pictures/raster.h"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <vector>

namespace polydec {

/// A triangle as it is seen: pixels to the right and down, and nearness to the eye in pixels.
struct SeenTriangle {
    std::array<Eigen::Vector3d, 3> corners;
    std::optional<std::array<double, 3>> parts = {}; ///< of the corners on the color map
    double brightness = 1;
    /// Lines on the sides, from corner i to the next.
    std::array<std::optional<Color>, 3> sides = {};
    double side_width = 0.7; ///< half the width of these lines, pixels
};

/// Paints triangles in any order; at each place the nearest one is seen. Four samples to a
/// pixel smooth the edges.
class SurfacePainter {
public:
    /// Values have the colors of this map, other triangles the plain color.
    SurfacePainter(int width, int height, std::vector<Color> map, Color plain);

    void paint(const SeenTriangle& triangle);

    Raster picture() const { return samples_.reduced(factor); }

    /// Whether something is painted at this place, which is not nearer than the point by more than
    /// some pixels.
    bool shows(const Eigen::Vector3d& point) const;

    /// A number from 0 to 1 as a color of the map.
    Color color(double part) const;

    /// Of a place in a triangle, by its barycentric coordinates, without lines.
    using Weights = std::array<double, 3>;
    Color color(const SeenTriangle& triangle, const Weights& weights) const;

private:
    static constexpr int factor = 2;

    /// The color of a triangle at a place with this part on the map.
    Color shaded(const SeenTriangle& triangle, double part) const;

    std::vector<Color> map_;
    Color plain_;
    Raster samples_;
    std::vector<float> nearness_; ///< of each sample
};

/// The colors of a map at so many places that steps between them are not seen.
std::vector<Color> fine_map(ColorMap map);

} // namespace polydec
