// SPDX-License-Identifier: MIT
#pragma once

#include "dec/metric/simplex_layout.h"

namespace polydec {

/// Throws InvalidInput, naming the vertex, for points that do not fit or are not finite, and for a
/// wrong number of lengths.
void check_metric(const Pieces& complex, const SimplexMetric& metric);

/// Products of a few volumes must neither overflow nor underflow.
inline bool is_moderate(double volume) {
    constexpr double largest = 1e100;
    return volume < largest && volume > 1 / largest;
}

/// The largest coordinate difference between two corners.
double largest_extent(const Corners& corners);

/// Throws InvalidInput; names the simplex of least dimension, among k-simplex t and its faces,
/// whose volume is unusable.
[[noreturn]] void refuse_volume(const Pieces& complex, const SimplexMetric& metric, int k, Index t);

} // namespace polydec
