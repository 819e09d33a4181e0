// SPDX-License-Identifier: MIT
#include "io/pictures/color_map.h"

#include "base/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <span>

namespace polydec {

namespace {

// lightness falls to the dark ends all the way
const Color sequential_colors[] = {{255, 248, 222}, {253, 218, 150}, {244, 165, 104},
                                   {214, 107, 107}, {160, 68, 118},  {92, 44, 112}};
const Color diverging_colors[] = {{13, 59, 112},   {49, 125, 180}, {157, 202, 225}, {246, 244, 240},
                                  {247, 190, 121}, {217, 108, 31}, {122, 48, 6}};

} // namespace

std::string color_text(const Color& color) {
    return fmt::format("#{:02x}{:02x}{:02x}", color[0], color[1], color[2]);
}

Color color_of(std::string_view text) {
    Color color{};
    for (std::size_t i = 0; i < 3; ++i)
        std::from_chars(text.data() + 1 + 2 * i, text.data() + 3 + 2 * i, color[i], 16);
    return color;
}

Color darker(Color color, double brightness) {
    for (auto& part : color)
        part = static_cast<std::uint8_t>(std::lround(brightness * part));
    return color;
}

double ColorRange::part(double value) const {
    if (is_constant)
        return 0.5;
    const double unit = std::isfinite(high - low) ? 1 : 0.5; // in which all differences are finite
    return (unit * value - unit * low) / (unit * high - unit * low);
}

ColorRange color_range(double low, double high) {
    constexpr double rounding = 1e-6;
    const double most = std::max(std::abs(low), std::abs(high));
    const bool is_constant = high - low <= rounding * most;
    if (is_constant) {
        const double middle = low / 2 + high / 2,
                     wide = std::isnormal(middle) ? std::abs(middle) / 100 : 1;
        return {ColorMap::sequential, middle - wide, middle + wide, true};
    }
    if (low < -rounding * most && high > rounding * most)
        return {ColorMap::diverging, -most, most, false};
    return {ColorMap::sequential, low, high, false};
}

std::string color_at(ColorMap map, double t) {
    if (std::isnan(t))
        throw InvalidInput("NaN has no color: correct the value");
    const std::span<const Color> colors = map == ColorMap::sequential
                                              ? std::span<const Color>(sequential_colors)
                                              : std::span<const Color>(diverging_colors);
    const double at = std::clamp(t, 0.0, 1.0) * static_cast<double>(colors.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(at), colors.size() - 2);
    const double part = at - static_cast<double>(i);
    Color mixed{};
    for (std::size_t c = 0; c < 3; ++c)
        mixed[c] = static_cast<std::uint8_t>(
            std::lround((1 - part) * colors[i][c] + part * colors[i + 1][c]));
    return color_text(mixed);
}

} // namespace polydec
