// SPDX-License-Identifier: MIT
#pragma once

#include "examples/plots/svg_plot.h"

#include <optional>
#include <string>
#include <vector>

namespace polydec {

struct SvgTick {
    double value;
    std::string text = {};            ///< empty at a minor tick
    std::optional<int> exponent = {}; ///< superscript after the text, as in 10^-3
};

/// The visible range of an axis.
struct SvgRange {
    Scale scale;
    double low, high; ///< of the numbers, or of their decimal logarithms

    /// Position of a number between low and high: 0 to 1.
    double position(double value) const;
};

/// A range that contains all numbers from least to greatest, with a margin at both ends.
SvgRange range_around(Scale scale, double least, double greatest);

/// Ticks in ascending order: at decades with minor ones between them, or at 1, 2 and 5 times
/// decades where there are fewer than two, or at equal round steps.
std::vector<SvgTick> ticks(const SvgRange& range);

} // namespace polydec
