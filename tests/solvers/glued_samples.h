// SPDX-License-Identifier: MIT
#pragma once

#include "tests/support/test.h"

namespace polydec::test {

/// A surface with lengths, and where its vertices lie, which nothing that is tested is told.
struct GluedSample {
    GluedSurface surface;
    Vector lengths;
    Points points;
};

/// The triangles of a mesh.
inline GluedSample glued(const Mesh& mesh) {
    const SimplicialComplex complex(mesh.simplices);
    return {GluedSurface(complex), edge_lengths(complex, mesh.points), mesh.points};
}

/// A grid with one vertex moved towards its neighbor until this part of their distance is left.
inline Mesh with_needle(double width) {
    Mesh mesh = grid(16, 16);
    const Index moved = 8 * 17 + 8;
    const Eigen::RowVector2d step = mesh.points.row(moved - 17) - mesh.points.row(moved);
    mesh.points.row(moved) += (1 - width) * step;
    return mesh;
}

enum class Closing { torus, klein_bottle };

/// The unit square in n x n squares cut in two, with opposite sides glued; for the bottle the left
/// one to the right one upside down. n = 1 gives two triangles on one vertex.
inline GluedSample flat(Index n, Closing closing = Closing::torus) {
    // at every place of the grid one edge to the right, one up, and a diagonal
    const auto place = [n](Index i, Index j) { return i * n + (j + n) % n; };
    const auto right = [&](Index i, Index j) { return 3 * place(i, j); };
    const auto diagonal = [&](Index i, Index j) { return 3 * place(i, j) + 2; };
    const auto up = [&](Index i, Index j) -> GluedSurface::SignedEdge {
        if (i < n)
            return {3 * place(i, j) + 1, 1};
        if (closing == Closing::torus)
            return {3 * place(0, j) + 1, 1};
        return {3 * place(0, n - 1 - j) + 1, -1};
    };
    const auto back = [](GluedSurface::SignedEdge side) {
        return GluedSurface::SignedEdge{side.edge, static_cast<std::int8_t>(-side.sign)};
    };
    std::vector<std::array<GluedSurface::SignedEdge, 3>> triangles;
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j) {
            triangles.push_back({{{right(i, j), 1}, up(i + 1, j), {diagonal(i, j), -1}}});
            triangles.push_back({{{diagonal(i, j), 1}, {right(i, j + 1), -1}, back(up(i, j))}});
        }
    GluedSample sample{GluedSurface(triangles), Vector(3 * n * n), Points(n * n, 2)};
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j) {
            sample.lengths.segment<3>(right(i, j)) << 1, 1, std::sqrt(2.0);
            sample.points.row(sample.surface.tail(6 * place(i, j))) << i, j;
        }
    sample.lengths /= n;
    sample.points /= n;
    return sample;
}

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
