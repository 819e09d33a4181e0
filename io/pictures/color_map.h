// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace polydec {

/// Red, green and blue from 0 to 255.
using Color = std::array<std::uint8_t, 3>;

/// The color as "#rrggbb", and that of such a text.
std::string color_text(const Color& color);
Color color_of(std::string_view text);

/// All three parts times a brightness from 0 to 1, rounded.
Color darker(Color color, double brightness);

/// Color maps that are safe for color blindness.
enum class ColorMap {
    sequential, ///< from light to dark
    diverging,  ///< blue below the middle, light in the middle, orange above
};

/// The colors of values in pictures and pages.
struct ColorRange {
    ColorMap map;
    double low, high; ///< values at the ends of the map; low < high
    bool is_constant; ///< the values are equal, up to rounding, and have the color in the middle

    double middle() const { return low / 2 + high / 2; }

    /// The place of a value on the map, 0 to 1; the middle if they are constant.
    double part(double value) const;
};

/// The default colors of values from `low` to `high`: diverging, from minus to plus the largest
/// absolute value, if both signs occur beyond rounding; else sequential, from low to high. If
/// these are equal up to rounding, they are in the middle, and the ends a hundredth from it.
/// Rounding is 1e-6 of the largest absolute value.
ColorRange color_range(double low, double high);

/// The color "#rrggbb" of a number from 0 to 1; other numbers are clamped. Throws InvalidInput for
/// NaN.
std::string color_at(ColorMap map, double t);

} // namespace polydec
