// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <string>

namespace polydec {

/// Red, green and blue from 0 to 255.
using Color = Eigen::Vector3d;

/// The color as "#rrggbb".
std::string color_text(const Color& color);

/// Color maps that are safe for color blindness.
enum class ColorMap {
    sequential, ///< from light to dark
    diverging,  ///< blue below the middle, light in the middle, orange above
};

/// The colors of values in pictures and pages.
struct ColorRange {
    ColorMap map;
    double low, high; ///< values at the ends of the map
    bool is_constant; ///< the values are equal, up to rounding
};

/// The default colors of values from `low` to `high`: diverging, from minus to plus the largest
/// absolute value, if both signs occur beyond rounding; else sequential, from low to high.
/// Rounding is 1e-6 of the largest absolute value.
ColorRange color_range(double low, double high);

/// The color "#rrggbb" of a number from 0 to 1; other numbers are clamped. Throws InvalidInput for
/// NaN.
std::string color_at(ColorMap map, double t);

} // namespace polydec
