// SPDX-License-Identifier: MIT
#include "shape/exact_distance.h"

#include "base/errors.h"
#include "shape/sources.h"
#include "shape/windows.h"

#include <fmt/format.h>

#include <cmath>

namespace polydec {

Vector exact_distance(const Triangles& surface, const Vector& lengths,
                      std::span<const Index> sources) {
    const UnfoldedTriangles unfolded(surface, lengths);
    check_sources(surface, sources);
    const auto found = distances_by_windows(unfolded, sources, most_windows(surface.triangles()));
    const Vector distances = found.distances.unaryExpr(
        [&](double distance) { return std::ldexp(distance, unfolded.exponent()); });
    for (Index v = 0; v < surface.vertices(); ++v)
        if (!std::isfinite(distances[v]))
            throw InvalidInput(fmt::format("the distance of vertex {} is out of the range of "
                                           "numbers: give lengths in a larger unit",
                                           v),
                               {.vertices = {v}});
    return distances;
}

} // namespace polydec
