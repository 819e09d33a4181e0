// SPDX-License-Identifier: MIT
#include "tests/support/diamond.h"

#include "tests/support/test.h"

namespace polydec::test {

PeriodicMesh diamond(int m) {
    std::map<std::pair<int, int>, Index> numbers;
    std::vector<std::pair<int, int>> points;
    std::vector<std::array<Index, 3>> triangles;
    const auto number = [&](int x, int y) {
        const auto [place, is_new] = numbers.emplace(std::pair(x, y), std::ssize(points));
        if (is_new)
            points.emplace_back(x, y);
        return place->second;
    };
    const auto add = [&](std::array<std::pair<int, int>, 3> corners) {
        std::array<Index, 3> rows{};
        for (std::size_t i = 0; i < 3; ++i) {
            if (std::abs(corners[i].first) + std::abs(corners[i].second) > m)
                return;
            rows[i] = number(corners[i].first, corners[i].second);
        }
        triangles.push_back(rows);
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
    Mesh box;
    box.points.resize(std::ssize(points), 2);
    box.simplices.resize(std::ssize(triangles), 3);
    for (std::size_t v = 0; v < points.size(); ++v)
        box.points.row(static_cast<Index>(v)) << points[v].first, points[v].second;
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (int i = 0; i < 3; ++i)
            box.simplices(static_cast<Index>(t), i) = triangles[t][static_cast<std::size_t>(i)];
    return periodic(std::move(box), {Vector{{1.0 * m, 1.0 * m}}, Vector{{1.0 * m, -1.0 * m}}});
}

PeriodicMesh unit_diamond(int m) {
    PeriodicMesh mesh = diamond(m);
    mesh.box.points /= m;
    mesh.points /= m;
    mesh.quotient.lengths /= m;
    return mesh;
}

} // namespace polydec::test
