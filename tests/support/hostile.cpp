// SPDX-License-Identifier: MIT
#include "tests/support/hostile.h"

#include "tests/support/test.h"

namespace polydec::test {

namespace {

/// Hands out choices, the first of each once there are no more bytes.
class Choices {
public:
    explicit Choices(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    /// 0 .. count-1.
    int below(int count) {
        if (bytes_.empty())
            return 0;
        const int byte = bytes_.front();
        bytes_ = bytes_.subspan(1);
        return byte % count;
    }

    template <class T, std::size_t size>
    T among(const std::array<T, size>& values) {
        return values[below(static_cast<int>(size))];
    }

private:
    std::span<const std::uint8_t> bytes_;
};

/// Simplices row by row.
struct Cells {
    int n;
    Index vertices = 0;
    std::vector<std::vector<Index>> rows = {};
};

std::vector<Index> consecutive(Index first, int count) {
    std::vector<Index> list(count);
    for (int i = 0; i < count; ++i)
        list[i] = first + i;
    return list;
}

/// Simplices put on facets of each other, with a new apex or one that is there: trees and books.
Cells grown(int n, Choices& choices) {
    Cells cells{n, n + 1, {consecutive(0, n + 1)}};
    for (int more = choices.below(12); more > 0; --more) {
        auto corners = cells.rows[choices.below(static_cast<int>(cells.rows.size()))];
        const bool new_apex = choices.below(4) != 3;
        const Index apex = new_apex ? cells.vertices : choices.below(cells.vertices);
        if (std::find(corners.begin(), corners.end(), apex) != corners.end())
            continue;
        corners[choices.below(n + 1)] = apex;
        cells.vertices += new_apex ? 1 : 0;
        cells.rows.push_back(std::move(corners));
    }
    return cells;
}

/// Corners drawn at random from few vertices.
Cells soup(int n, Choices& choices) {
    Cells cells{n, n + 1 + choices.below(5)};
    for (int more = 1 + choices.below(8); more > 0; --more) {
        auto all = consecutive(0, cells.vertices);
        for (int i = 0; i <= n; ++i)
            std::swap(all[i], all[i + choices.below(cells.vertices - i)]);
        cells.rows.emplace_back(all.begin(), all.begin() + n + 1);
    }
    return cells;
}

/// Every n+1 consecutive vertices of a cycle: a closed band, one-sided or not.
Cells ring(int n, Choices& choices) {
    const Index length = 2 * n + 1 + choices.below(5);
    Cells cells{n, length};
    for (Index first = 0; first < length; ++first) {
        auto corners = consecutive(first, n + 1);
        for (Index& v : corners)
            v %= length;
        cells.rows.push_back(std::move(corners));
    }
    return cells;
}

/// Corners on a small grid, so that many are cospherical.
Points on_a_grid(Index count, int N, Choices& choices) {
    Points points(count, N);
    for (double& x : points.reshaped<Eigen::RowMajor>())
        x = (choices.below(7) + 4) % 7 - 3;
    return points;
}

Mesh cubes(int n, int N, Choices& choices) {
    constexpr int few_enough = 3;
    const int cells = n <= few_enough ? 1 + choices.below(2) : 1;
    Mesh mesh = kuhn(n, cells);
    const Points flat = mesh.points;
    mesh.points = Points::Zero(flat.rows(), N);
    mesh.points.leftCols(n) = flat;
    for (Index bent = n; bent < N; ++bent)
        mesh.points.col(bent) = choices.below(3) * flat.col(0).cwiseAbs2();
    return mesh;
}

} // namespace

Mesh hostile_mesh(std::span<const std::uint8_t> bytes) {
    Choices choices(bytes);
    const int n = choices.among(std::array{2, 1, 3, 2, 3, 4, 2, 5});
    const int N = n + choices.among(std::array{0, 0, 1, 0, 2, 0, 1, 0});
    const int kind = choices.below(4);
    const double jitter = choices.among(std::array{0., 0., 1e-14, 1e-8, 3e-5, 1e-3, .1, .3});
    const double flatness = choices.among(std::array{1., 1., 1., 1e-1, 1e-2, 1e-4, 1e-6});
    const double scale =
        choices.among(std::array{1., 1., 1., 1e-8, 1e8, 1e-100, 1e100, 1e-150, 1e150});

    Mesh mesh;
    if (kind == 1) {
        mesh = cubes(n, N, choices);
    } else {
        const Cells cells = kind == 0   ? grown(n, choices)
                            : kind == 2 ? soup(n, choices)
                                        : ring(n, choices);
        mesh = made_of({{}}, cells.rows);
        mesh.points = on_a_grid(cells.vertices, N, choices);
    }
    for (double& x : mesh.points.reshaped<Eigen::RowMajor>())
        x += jitter * (choices.below(255) - 127) / 127.;
    mesh.points.col(0) *= flatness;
    mesh.points *= scale;
    return mesh;
}

} // namespace polydec::test
