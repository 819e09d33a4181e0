// SPDX-License-Identifier: MIT
#include "base/decompositions.h"
#include "meshes/generate.h"
#include "meshes/generate_parts.h"

#include <array>
#include <utility>

namespace polydec {

namespace {

using Place = std::array<Index, 4>; // in half cubes, or steps between two places

constexpr Index no_vertex = -1;

bool is_even(const Place& p) {
    return (p[0] + p[1] + p[2] + p[3]) % 2 == 0;
}

Place plus(Place p, const Place& step) {
    for (int k = 0; k < 4; ++k)
        p[k] += step[k];
    return p;
}

/// Calls f with every place below the given sizes, in lexicographic order.
template <typename F>
void for_each_place(const Place& sizes, F f) {
    for (Index i = 0; i < sizes[0]; ++i)
        for (Index j = 0; j < sizes[1]; ++j)
            for (Index k = 0; k < sizes[2]; ++k)
                for (Index l = 0; l < sizes[3]; ++l)
                    f(Place{i, j, k, l});
}

class Lattice {
public:
    explicit Lattice(const std::vector<int>& cells) {
        for (int k = 0; k < 4; ++k)
            sizes_[k] = 2 * cells[k] + 1;
        numbers_.reserve(static_cast<std::size_t>(sizes_[0]) * sizes_[1] * sizes_[2] * sizes_[3]);
        for_each_place(sizes_, [&](const Place& p) {
            numbers_.push_back(is_even(p) ? static_cast<Index>(places_.size()) : no_vertex);
            if (is_even(p))
                places_.push_back(p);
        });
    }

    const Place& sizes() const { return sizes_; }
    const std::vector<Place>& places() const { return places_; }

    /// The vertex there, no_vertex outside the box.
    Index vertex(const Place& p) const {
        std::size_t number = 0;
        for (int k = 0; k < 4; ++k) {
            if (p[k] < 0 || p[k] >= sizes_[k])
                return no_vertex;
            number = number * sizes_[k] + p[k];
        }
        return numbers_[number];
    }

private:
    Place sizes_{};
    std::vector<Index> numbers_; // of all places
    std::vector<Place> places_;  // of the vertices
};

using Diagonal = std::pair<Place, Place>;

/// What of a 16-cell, given by its four diagonals, lies in the box: simplices around the first
/// diagonal that does.
void add_16_cell(Mesh& mesh, Eigen::Index& next, const Lattice& lattice,
                 std::array<Diagonal, 4> diagonals) {
    const auto lies_inside = [&](const Diagonal& d) {
        return lattice.vertex(d.first) != no_vertex && lattice.vertex(d.second) != no_vertex;
    };
    for (auto& diagonal : diagonals)
        if (lies_inside(diagonal)) {
            std::swap(diagonal, diagonals[0]);
            break;
        }

    for (int signs = 0; signs < 8; ++signs) {
        std::array<Place, 5> corners{diagonals[0].first, diagonals[0].second};
        for (int k = 0; k < 3; ++k)
            corners[k + 2] = signs >> k & 1 ? diagonals[k + 1].second : diagonals[k + 1].first;
        Eigen::Matrix4d edges;
        bool is_inside = true;
        for (int c = 0; c < 5; ++c)
            is_inside = is_inside && lattice.vertex(corners[c]) != no_vertex;
        if (!is_inside)
            continue;
        for (int c = 1; c < 5; ++c)
            for (int k = 0; k < 4; ++k)
                edges(c - 1, k) = corners[c][k] - corners[0][k];
        if (edges.determinant() < 0.0)
            std::swap(corners[0], corners[1]);
        for (int c = 0; c < 5; ++c)
            mesh.simplices(next, c) = lattice.vertex(corners[c]);
        ++next;
    }
}

/// Opposite neighbors of a place, along the axes.
std::array<Diagonal, 4> around(const Place& p) {
    std::array<Diagonal, 4> result;
    for (int k = 0; k < 4; ++k) {
        result[k] = {p, p};
        --result[k].first[k];
        ++result[k].second[k];
    }
    return result;
}

/// Opposite even corners of the small cube whose lowest corner is given.
std::array<Diagonal, 4> within(const Place& lowest) {
    constexpr std::array<Place, 8> corners{{{0, 0, 0, 0},
                                            {0, 0, 1, 1},
                                            {0, 1, 0, 1},
                                            {0, 1, 1, 0},
                                            {0, 0, 0, 1},
                                            {0, 0, 1, 0},
                                            {0, 1, 0, 0},
                                            {0, 1, 1, 1}}};
    std::array<Diagonal, 4> result;
    for (int k = 0; k < 4; ++k) {
        const Place& corner = corners[is_even(lowest) ? k : k + 4];
        Place opposite{};
        for (int axis = 0; axis < 4; ++axis)
            opposite[axis] = 1 - corner[axis];
        result[k] = {plus(lowest, corner), plus(lowest, opposite)};
    }
    return result;
}

} // namespace

Mesh d4(const std::vector<int>& cells, double edge) {
    const double cubes = check_cubes("d4", cells, 4, edge);
    double places = 1.0;
    for (const int count : cells)
        places *= 2.0 * count + 1.0;
    check_sizes("d4", places, 192 * cubes);

    const Lattice lattice(cells);
    Mesh mesh;
    mesh.points.resize(static_cast<Eigen::Index>(lattice.places().size()), 4);
    for (Eigen::Index v = 0; v < mesh.points.rows(); ++v)
        for (int k = 0; k < 4; ++k)
            mesh.points(v, k) = lattice.places()[v][k] / (2.0 * cells[k]) * (cells[k] * edge);

    mesh.simplices.resize(static_cast<Eigen::Index>(192 * cubes), 5);
    Eigen::Index next = 0;
    for_each_place(lattice.sizes(), [&](const Place& p) {
        if (!is_even(p))
            add_16_cell(mesh, next, lattice, around(p));
    });
    for_each_place(plus(lattice.sizes(), {-1, -1, -1, -1}),
                   [&](const Place& p) { add_16_cell(mesh, next, lattice, within(p)); });
    return mesh;
}

Mesh d4(int cells) {
    check_count("d4", "cells", cells, 1);
    return d4({cells, cells, cells, cells}, 1.0 / cells);
}

} // namespace polydec
