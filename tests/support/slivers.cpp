// SPDX-License-Identifier: MIT
#include "tests/support/slivers.h"

#include "meshes/delaunay.h"
#include "tests/support/test.h"

namespace polydec::test {

Mesh delaunay_grid(int m, double jitter, std::uint64_t seed) {
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

Mesh five_to_a_cube(int m, bool fitting) {
    const int p = m + 1;
    const auto number = [p](int i, int j, int k) { return Index((i * p + j) * p + k); };
    Points points(p * p * p, 3);
    for (int i = 0; i < p; ++i)
        for (int j = 0; j < p; ++j)
            for (int k = 0; k < p; ++k)
                points.row(number(i, j, k)) << i, j, k;
    Vector noise(m * m * m);
    Noise(5).fill(noise);
    const auto way = [&](int i, int j, int k) {
        return fitting ? (i + j + k) % 2 : int(noise[(i * m + j) * m + k] > 0);
    };
    const auto is_odd = [](int a) { return ((a ^ a >> 1 ^ a >> 2) & 1) != 0; };
    std::vector<std::vector<Index>> cells;
    for (int i = 0; i < m; ++i)
        for (int j = 0; j < m; ++j)
            for (int k = 0; k < m; ++k) {
                const auto corner = [&](int a) {
                    return number(i + (a & 1), j + (a >> 1 & 1), k + (a >> 2 & 1));
                };
                std::vector<Index> inner;
                for (int a = 0; a < 8; ++a)
                    if (is_odd(a) == (way(i, j, k) == 1))
                        inner.push_back(corner(a));
                    else
                        cells.push_back({corner(a), corner(a ^ 1), corner(a ^ 2), corner(a ^ 4)});
                cells.push_back(inner);
                const std::array<int, 3> place{i, j, k};
                for (int axis = 0; axis < 3; ++axis) {
                    std::array<int, 3> next = place;
                    if (++next[axis] == m || way(i, j, k) != way(next[0], next[1], next[2]))
                        continue; // nothing behind, or the same diagonal
                    std::vector<Index> square;
                    for (int a = 0; a < 8; ++a)
                        if ((a >> axis & 1) == 1)
                            square.push_back(corner(a));
                    cells.push_back(square);
                }
            }
    return {points, made_of({{}}, cells).simplices, {}};
}

Mesh hexagonal_prisms() {
    std::vector<std::vector<double>> points;
    for (int level = 0; level < 3; ++level)
        for (int i = 0; i < 6; ++i)
            points.push_back({std::cos(i * M_PI / 3), std::sin(i * M_PI / 3), double(level)});
    std::vector<std::vector<Index>> cells{{6, 7, 8, 9}, {6, 7, 9, 10}, {6, 7, 10, 11}};
    const auto cut = [&](Index middle, Index far, Index fan) { // from corner 0 of the far hexagon
        for (Index i = 1; i < 5; ++i)
            cells.push_back(
                {far, middle + fan, middle + (fan + i) % 6, middle + (fan + i + 1) % 6});
        for (Index i = 1; i < 5; ++i) { // the sides away from it
            cells.push_back({far, middle + i, middle + i + 1, far + i});
            cells.push_back({far, middle + i + 1, far + i, far + i + 1});
        }
    };
    cut(6, 12, 0);
    cut(6, 0, 1);
    return made_of(points, cells);
}

} // namespace polydec::test
