// SPDX-License-Identifier: MIT
#include "shape/geodesics.h"
#include "shape/sources.h"
#include "shape/windows.h"

namespace polydec {

Vector exact_distance(const Triangles& surface, const Vector& lengths,
                      std::span<const Index> sources) {
    const UnfoldedTriangles unfolded(surface, lengths);
    check_sources(surface, sources);
    const auto found = distances_by_windows(unfolded, sources, most_windows(surface.triangles()));
    return in_units_of_lengths(surface, found.distances, unfolded.exponent());
}

} // namespace polydec
