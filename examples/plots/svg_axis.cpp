// SPDX-License-Identifier: MIT
#include "examples/plots/svg_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace polydec {

namespace {

constexpr double room = 0.05; // at both ends, of the range
constexpr int most_labels = 8;

std::vector<SvgTick> linear_ticks(double low, double high) {
    const double rough = (high - low) / 6;
    const double decade = std::pow(10, std::floor(std::log10(rough)));
    double step = 10 * decade;
    for (const double factor : {5, 2, 1})
        if (factor * decade >= rough)
            step = factor * decade;

    std::vector<SvgTick> result;
    const int digits = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
    const bool plain = digits <= 4 && std::max(std::abs(low), std::abs(high)) < 1e5;
    for (double i = std::ceil(low / step); i * step <= high; ++i) {
        const double value = i == 0 ? 0 : i * step; // no -0
        result.push_back(
            {value, plain ? fmt::format("{:.{}f}", value, digits) : fmt::format("{:.4g}", value)});
    }
    return result;
}

/// 1, 2 and 5 times decades, or all multiples, with their labels.
std::vector<SvgTick> multiples(double low, double high, const std::vector<int>& factors) {
    std::vector<SvgTick> result;
    for (int k = static_cast<int>(std::floor(low)); k <= std::ceil(high); ++k)
        for (const int m : factors) {
            const double exponent = k + std::log10(m);
            if (exponent < low || exponent > high)
                continue;
            const double value = m * std::pow(10, k);
            if (k >= -3 && k <= 3)
                result.push_back({value, fmt::format("{:g}", value)});
            else
                result.push_back({value, m == 1 ? "10" : fmt::format("{}·10", m), k});
        }
    return result;
}

std::vector<SvgTick> decades(double low, double high) {
    const int first = static_cast<int>(std::floor(low)), last = static_cast<int>(std::ceil(high));
    const int step = 1 + (last - first) / (most_labels + 1);
    std::vector<SvgTick> result;
    for (int k = first; k <= last; ++k)
        for (int m = 1; m < (step == 1 ? 10 : 2); ++m) {
            const double exponent = k + std::log10(m);
            if (exponent < low || exponent > high)
                continue;
            SvgTick tick{m * std::pow(10, k)};
            if (m == 1 && k % step == 0) {
                tick.text = "10";
                tick.exponent = k;
            }
            result.push_back(tick);
        }
    return result;
}

} // namespace

double SvgRange::position(double value) const {
    return ((scale == Scale::logarithmic ? std::log10(value) : value) - low) / (high - low);
}

SvgRange range_around(Scale scale, double least, double greatest) {
    const bool logarithmic = scale == Scale::logarithmic;
    SvgRange range{scale, logarithmic ? std::log10(least) : least,
                   logarithmic ? std::log10(greatest) : greatest};
    const double size = range.high - range.low;
    const double least_size = logarithmic ? 0.01 : 1e-6 * std::abs(greatest);
    if (size > least_size) {
        range.low -= room * size;
        range.high += room * size;
    } else { // all at one point: a margin around it
        const double half = logarithmic ? 0.5 : greatest == 0 ? 1 : 0.5 * std::abs(greatest);
        range.low -= half;
        range.high += half;
    }
    return range;
}

std::vector<SvgTick> ticks(const SvgRange& range) {
    if (range.scale == Scale::linear)
        return linear_ticks(range.low, range.high);
    if (std::floor(range.high) - std::ceil(range.low) >= 1)
        return decades(range.low, range.high);
    for (const auto& factors : {std::vector{1, 2, 5}, std::vector{1, 2, 3, 4, 5, 6, 7, 8, 9}}) {
        auto found = multiples(range.low, range.high, factors);
        if (found.size() >= 3)
            return found;
    }
    return linear_ticks(std::pow(10, range.low), std::pow(10, range.high));
}

} // namespace polydec
