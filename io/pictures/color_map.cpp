// SPDX-License-Identifier: MIT
#include "io/pictures/color_map.h"

#include "base/errors.h"

#include <fmt/format.h>

#include <algorithm>
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
    const auto part = [&](int i) { return static_cast<int>(std::lround(color[i])); };
    return fmt::format("#{:02x}{:02x}{:02x}", part(0), part(1), part(2));
}

ColorRange color_range(double low, double high) {
    constexpr double rounding = 1e-6;
    const double most = std::max(std::abs(low), std::abs(high));
    const bool is_constant = high - low <= rounding * most;
    if (!is_constant && low < -rounding * most && high > rounding * most)
        return {ColorMap::diverging, -most, most, false};
    return {ColorMap::sequential, low, high, is_constant};
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
    return color_text((1 - part) * colors[i] + part * colors[i + 1]);
}

} // namespace polydec
