// SPDX-License-Identifier: MIT
#include "tests/support/diamond.h"

#include "tests/support/test.h"

namespace polydec::test {

PeriodicMesh diamond(int m) {
    std::map<std::pair<int, int>, Index> numbers;
    std::vector<std::vector<double>> points;
    std::vector<std::vector<Index>> triangles;
    const auto number = [&](int x, int y) {
        const auto [place, is_new] = numbers.emplace(std::pair(x, y), std::ssize(points));
        if (is_new)
            points.push_back({1.0 * x, 1.0 * y});
        return place->second;
    };
    const auto add = [&](std::array<std::pair<int, int>, 3> corners) {
        std::vector<Index> row;
        for (const auto& [x, y] : corners) {
            if (std::abs(x) + std::abs(y) > m)
                return;
            row.push_back(number(x, y));
        }
        triangles.push_back(row);
    };
    for (int x = -m; x < m; ++x)
        for (int y = -m; y < m; ++y) {
            const std::pair a(x, y), b(x + 1, y), c(x + 1, y + 1), d(x, y + 1);
            if ((x < 0) == (y < 0)) { // along the side that is near
                add({a, b, d});
                add({b, c, d});
            } else {
                add({a, b, c});
                add({a, c, d});
            }
        }
    return periodic(made_of(points, triangles),
                    {Vector{{1.0 * m, 1.0 * m}}, Vector{{1.0 * m, -1.0 * m}}});
}

PeriodicMesh unit_diamond(int m) {
    PeriodicMesh mesh = diamond(m);
    mesh.box.points /= m;
    mesh.points /= m;
    mesh.quotient.lengths /= m;
    return mesh;
}

} // namespace polydec::test
