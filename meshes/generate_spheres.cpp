// SPDX-License-Identifier: MIT
#include "meshes/generate.h"
#include "meshes/generate_parts.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace polydec {

namespace {

constexpr double golden_ratio = std::numbers::phi;

/// A vector whose coordinate c is whole[c] + golden[c] times the golden ratio: sums of corners of
/// the icosahedron are exact, and what is rounded later respects its symmetries.
struct GoldenVector {
    using Integers = Eigen::Matrix<std::int64_t, 1, 3>;
    Integers whole;
    Integers golden;

    Eigen::RowVector3d direction() const {
        const double square = static_cast<double>(whole.dot(whole) + golden.dot(golden)) +
                              golden_ratio * static_cast<double>(golden.dot(2 * whole + golden));
        return (whole.cast<double>() + golden_ratio * golden.cast<double>()) / std::sqrt(square);
    }
};

/// Corners, edges and faces of the icosahedron with the edge length 2.
class Icosahedron {
public:
    Icosahedron() {
        for (int axis = 0; axis < 3; ++axis)
            for (const int one : {-1, 1})
                for (const int ratio : {-1, 1}) {
                    GoldenVector corner{{0, 0, 0}, {0, 0, 0}};
                    corner.whole[(axis + 1) % 3] = one;
                    corner.golden[(axis + 2) % 3] = ratio;
                    corners_.push_back(corner);
                }
        for (auto& row : edge_numbers_)
            row.fill(-1);
        for (Index a = 0; a < 12; ++a)
            for (Index b = a + 1; b < 12; ++b)
                if (adjacent(a, b))
                    edge_numbers_[a][b] = edges_++;
        for (Index a = 0; a < 12; ++a)
            for (Index b = a + 1; b < 12; ++b)
                for (Index c = b + 1; c < 12; ++c)
                    if (adjacent(a, b) && adjacent(b, c) && adjacent(c, a))
                        add_face(a, b, c);
    }

    const GoldenVector& corner(Index a) const { return corners_[a]; }
    const std::vector<std::array<Index, 3>>& faces() const { return faces_; }

    /// Number of the edge between adjacent corners a < b.
    Index edge(Index a, Index b) const { return edge_numbers_[a][b]; }

private:
    Eigen::RowVector3d place(Index a) const {
        return corners_[a].whole.cast<double>() + golden_ratio * corners_[a].golden.cast<double>();
    }
    bool adjacent(Index a, Index b) const { return (place(a) - place(b)).norm() < 2.5; }
    void add_face(Index a, Index b, Index c) {
        const bool outward = place(a).dot(place(b).cross(place(c))) > 0.0;
        faces_.push_back(outward ? std::array{a, b, c} : std::array{a, c, b});
    }

    std::vector<GoldenVector> corners_;
    std::vector<std::array<Index, 3>> faces_;
    std::array<std::array<Index, 12>, 12> edge_numbers_;
    Index edges_ = 0;
};

/// The icosahedron with every face cut into frequency^2 triangles. A lattice point of a face has
/// integer weights at its three corners, which add up to the frequency.
class DividedIcosahedron {
public:
    using Weights = std::array<Index, 3>;

    explicit DividedIcosahedron(Index frequency) : f_(frequency) {}

    /// Corners of the icosahedron come first, then the points on its edges, then the others.
    Index vertex(Index face, const Weights& weights) const {
        const auto& corners = icosahedron_.faces()[face];
        for (int c = 0; c < 3; ++c) {
            const int next = (c + 1) % 3;
            if (weights[c] == f_)
                return corners[c];
            if (weights[c] + weights[next] == f_ && weights[next] < f_)
                return edge_vertex(corners[c], corners[next], weights[next]);
        }
        const Index inside = (f_ - 1) * (f_ - 2) / 2;
        const Index row = weights[0] - 1, before = row * (f_ - 2) - row * (row - 1) / 2;
        return 12 + 30 * (f_ - 1) + face * inside + before + weights[1] - 1;
    }

    Eigen::RowVector3d place(Index face, const Weights& weights) const {
        GoldenVector sum{{0, 0, 0}, {0, 0, 0}};
        for (int c = 0; c < 3; ++c) {
            const GoldenVector& corner = icosahedron_.corner(icosahedron_.faces()[face][c]);
            sum.whole += weights[c] * corner.whole;
            sum.golden += weights[c] * corner.golden;
        }
        return sum.direction();
    }

private:
    Index edge_vertex(Index a, Index b, Index steps_from_a) const {
        if (a > b)
            return edge_vertex(b, a, f_ - steps_from_a);
        return 12 + icosahedron_.edge(a, b) * (f_ - 1) + steps_from_a - 1;
    }

    Icosahedron icosahedron_;
    Index f_;
};

} // namespace

Mesh uv_sphere(int meridians, int bands) {
    check_count("uv_sphere", "meridians", meridians, 3);
    check_count("uv_sphere", "bands", bands, 2);
    check_sizes("uv_sphere", meridians * (bands - 1.0) + 2.0, 2.0 * meridians * (bands - 1.0));

    const Index south = meridians * (bands - 1) + 1;
    const auto vertex = [&](Index parallel, Index i) {
        return 1 + (parallel - 1) * meridians + i % meridians;
    };
    Mesh mesh;
    mesh.points.resize(south + 1, 3);
    mesh.points.row(0) << 0.0, 0.0, 1.0;
    mesh.points.row(south) << 0.0, 0.0, -1.0;
    for (Index parallel = 1; parallel < bands; ++parallel) {
        const Eigen::Vector2d height = circle_point(parallel, 2 * static_cast<std::int64_t>(bands));
        for (Index i = 0; i < meridians; ++i) {
            const Eigen::Vector2d direction = circle_point(i, meridians);
            mesh.points.row(vertex(parallel, i)) << height.y() * direction.x(),
                height.y() * direction.y(), height.x();
        }
    }

    mesh.simplices.resize(2 * (south - 1), 3);
    Index triangle = 0;
    for (Index i = 0; i < meridians; ++i) {
        mesh.simplices.row(triangle++) << 0, vertex(1, i), vertex(1, i + 1);
        mesh.simplices.row(triangle++) << south, vertex(bands - 1, i + 1), vertex(bands - 1, i);
    }
    for (Index p = 1; p + 1 < bands; ++p)
        for (Index i = 0; i < meridians; ++i) {
            const Index opposite = vertex(p + 1, i + 1);
            mesh.simplices.row(triangle++) << vertex(p, i), vertex(p + 1, i), opposite;
            mesh.simplices.row(triangle++) << vertex(p, i), opposite, vertex(p, i + 1);
        }
    return mesh;
}

Mesh icosphere(int frequency) {
    check_count("icosphere", "frequency", frequency, 1);
    const double f = frequency;
    check_sizes("icosphere", 10 * f * f + 2, 20 * f * f);

    const DividedIcosahedron divided(frequency);
    Mesh mesh;
    mesh.points.resize(10 * frequency * frequency + 2, 3);
    mesh.simplices.resize(20 * frequency * frequency, 3);
    Index triangle = 0;
    for (Index face = 0; face < 20; ++face)
        for (Index a = 0; a <= frequency; ++a)
            for (Index b = 0; a + b <= frequency; ++b) {
                const Index c = frequency - a - b;
                const Index here = divided.vertex(face, {a, b, c});
                mesh.points.row(here) = divided.place(face, {a, b, c});
                if (c == 0)
                    continue;
                const Index to_a = divided.vertex(face, {a + 1, b, c - 1});
                const Index to_b = divided.vertex(face, {a, b + 1, c - 1});
                mesh.simplices.row(triangle++) << here, to_a, to_b;
                if (c == 1)
                    continue;
                const Index across = divided.vertex(face, {a + 1, b + 1, c - 2});
                mesh.simplices.row(triangle++) << to_a, across, to_b;
            }
    return mesh;
}

} // namespace polydec
