// SPDX-License-Identifier: MIT
#pragma once

#include "base/random.h"
#include "meshes/delaunay.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace polydec::test {

/// Delaunay tetrahedra of the points of m^3 cubes of edge 1/m, each moved by at most jitter / m
/// along what of the boundary it lies on.
inline Mesh delaunay_grid(int m, double jitter, std::uint64_t seed = 1) {
    const auto fixed = [m](int i) { return i == 0 || i == m; };
    std::vector<std::array<int, 3>> places;
    for (int i = 0; i <= m; ++i)
        for (int j = 0; j <= m; ++j)
            for (int k = 0; k <= m; ++k)
                places.push_back({i, j, k});
    std::stable_partition(places.begin(), places.end(), [&](const std::array<int, 3>& place) {
        return fixed(place[0]) && fixed(place[1]) && fixed(place[2]);
    });
    Points points(places.size(), 3), noise = points;
    Noise(static_cast<std::uint32_t>(seed)).fill(noise.reshaped());
    for (Index v = 0; v < points.rows(); ++v)
        for (int axis = 0; axis < 3; ++axis)
            points(v, axis) =
                (places[v][axis] + (fixed(places[v][axis]) ? 0 : 2 * jitter * noise(v, axis))) / m;
    return delaunay_in_cube(points, 1.0 / m, seed);
}

} // namespace polydec::test
