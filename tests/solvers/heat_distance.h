// SPDX-License-Identifier: MIT
#pragma once

#include "tests/support/test.h"

namespace polydec::test {

/// These options with the heat method.
inline GeodesicOptions by_heat(GeodesicOptions options = {}) {
    options.method = DistanceMethod::heat;
    return options;
}

/// Distances by the heat method.
inline Vector heat_distance(const Triangles& surface, const Vector& lengths,
                            std::span<const Index> sources, const GeodesicOptions& options = {}) {
    return geodesic_distance(surface, lengths, sources, by_heat(options));
}

inline Vector heat_distance(const Discretization& mesh, std::span<const Index> sources,
                            const GeodesicOptions& options = {}) {
    return geodesic_distance(mesh, sources, by_heat(options));
}

} // namespace polydec::test
