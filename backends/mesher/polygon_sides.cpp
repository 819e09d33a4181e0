// SPDX-License-Identifier: MIT
#include "backends/mesher/polygon_sides.h"

#include <algorithm>
#include <tuple>

namespace polydec {

std::vector<PolygonSide> sorted_sides(std::span<const Index> corners,
                                      std::span<const Index> offsets) {
    std::vector<PolygonSide> sides;
    sides.reserve(corners.size());
    for (std::size_t f = 0; f + 1 < offsets.size(); ++f) {
        for (Index i = offsets[f]; i < offsets[f + 1]; ++i) {
            const Index next = i + 1 < offsets[f + 1] ? i + 1 : offsets[f];
            const Index a = corners[static_cast<std::size_t>(i)];
            const Index b = corners[static_cast<std::size_t>(next)];
            sides.push_back({std::min(a, b), std::max(a, b), static_cast<Index>(f), a < b});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const PolygonSide& a, const PolygonSide& b) {
        return std::tie(a.low, a.high, a.polygon) < std::tie(b.low, b.high, b.polygon);
    });
    return sides;
}

} // namespace polydec
