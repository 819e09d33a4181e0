// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <span>
#include <vector>

namespace polydec {

/// An edge as a polygon runs along it.
struct PolygonSide {
    Index low, high; ///< the corners, low < high
    Index polygon;
    bool ascends; ///< whether the polygon runs from low to high
    bool beside(const PolygonSide& other) const { return low == other.low && high == other.high; }
};

/// The sides of polygons whose corners offsets[f] to offsets[f + 1] - 1 follow each other around
/// polygon f, by edge and then by polygon.
std::vector<PolygonSide> sorted_sides(std::span<const Index> corners,
                                      std::span<const Index> offsets);

} // namespace polydec
