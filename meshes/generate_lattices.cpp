// SPDX-License-Identifier: MIT
#include "meshes/generate_lattices.h"

#include "base/errors.h"
#include "meshes/generate_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace polydec {

namespace {

using Triple = std::array<Index, 3>;

/// Vertex number steps along the axes of a box of vertices numbered lexicographically.
std::vector<Index> strides(const std::vector<int>& cells) {
    std::vector<Index> result(cells.size(), 1);
    for (std::size_t k = cells.size(); k-- > 1;)
        result[k - 1] = result[k] * (cells[k] + 1);
    return result;
}

void check_box(const std::vector<int>& cells, const std::vector<double>& lengths) {
    check_count("kuhn", "n", static_cast<std::int64_t>(cells.size()), 1, 12);
    double vertices = 1.0, simplices = 1.0;
    for (std::size_t k = 0; k < cells.size(); ++k) {
        check_count("kuhn", fmt::format("cells[{}]", k), cells[k], 1);
        vertices *= cells[k] + 1.0;
        simplices *= (k + 1.0) * cells[k];
    }
    if (!lengths.empty() && lengths.size() != cells.size())
        throw InvalidInput(
            fmt::format("kuhn: {} lengths for {} axes; give one for each axis, or none",
                        lengths.size(), cells.size()));
    for (std::size_t k = 0; k < lengths.size(); ++k)
        check_length("kuhn", fmt::format("lengths[{}]", k), lengths[k]);
    check_sizes("kuhn", vertices, simplices);
}

bool is_odd(const std::vector<int>& permutation) {
    int inversions = 0;
    for (std::size_t i = 0; i < permutation.size(); ++i)
        for (std::size_t j = i + 1; j < permutation.size(); ++j)
            inversions += permutation[i] > permutation[j];
    return inversions % 2 == 1;
}

/// Tetrahedra of a mesh in R^3 that is filled one after the other.
class Tetrahedra {
public:
    Tetrahedra(Mesh& mesh, Index count) : mesh_(mesh) { mesh_.simplices.resize(count, 4); }
    void add(Index a, Index b, Index c, Index d) { mesh_.simplices.row(next_++) << a, b, c, d; }

private:
    Mesh& mesh_;
    Index next_ = 0;
};

/// Calls f with every triple below the given sizes, in lexicographic order.
template <typename F>
void for_each_triple(const Triple& sizes, F f) {
    for (Index i = 0; i < sizes[0]; ++i)
        for (Index j = 0; j < sizes[1]; ++j)
            for (Index k = 0; k < sizes[2]; ++k)
                f(Triple{i, j, k});
}

/// Numbers and places of the vertices of cubic lattices: corners first, then the others.
struct Cubes {
    Index cells;

    Index corner(const Triple& p) const { return (p[0] * (cells + 1) + p[1]) * (cells + 1) + p[2]; }
    Index corners() const { return (cells + 1) * (cells + 1) * (cells + 1); }
    Index center(const Triple& p) const { return corners() + (p[0] * cells + p[1]) * cells + p[2]; }

    /// Center of the square at the low end of cube p along an axis; p may be one beyond the last.
    Index face_center(int axis, const Triple& p) const {
        const Index layer = p[axis] * cells + p[(axis + 1) % 3];
        return corners() + axis * (cells + 1) * cells * cells + layer * cells + p[(axis + 2) % 3];
    }

    /// Place of a point given in half cubes.
    Eigen::RowVector3d place(const Triple& halves) const {
        return Eigen::RowVector3d(halves[0], halves[1], halves[2]) / (2.0 * cells);
    }
    void place_corners(Points& points) const {
        for_each_triple({cells + 1, cells + 1, cells + 1}, [&](const Triple& p) {
            points.row(corner(p)) = place({2 * p[0], 2 * p[1], 2 * p[2]});
        });
    }
};

/// A triple given along `axis` and the two axes that follow it in cyclic order.
Triple along(int axis, Index a, Index b, Index c) {
    Triple p{};
    p[axis] = a;
    p[(axis + 1) % 3] = b;
    p[(axis + 2) % 3] = c;
    return p;
}

/// Tetrahedra on both sides of the square at the low end of cube (layer, u, v) along an axis.
void add_bcc_square(Tetrahedra& tetrahedra, const Cubes& cubes, int axis, const Triple& place) {
    const auto [layer, u, v] = place;
    const std::array<Index, 4> square{
        cubes.corner(along(axis, layer, u, v)), cubes.corner(along(axis, layer, u + 1, v)),
        cubes.corner(along(axis, layer, u + 1, v + 1)), cubes.corner(along(axis, layer, u, v + 1))};

    if (layer == 0) {
        const Index above = cubes.center(along(axis, layer, u, v));
        tetrahedra.add(square[0], square[1], square[2], above);
        tetrahedra.add(square[0], square[2], square[3], above);
    } else if (layer == cubes.cells) {
        const Index below = cubes.center(along(axis, layer - 1, u, v));
        tetrahedra.add(square[0], square[2], square[1], below);
        tetrahedra.add(square[0], square[3], square[2], below);
    } else {
        const Index below = cubes.center(along(axis, layer - 1, u, v));
        const Index above = cubes.center(along(axis, layer, u, v));
        for (int side = 0; side < 4; ++side)
            tetrahedra.add(below, square[side], square[(side + 1) % 4], above);
    }
}

/// Corner tetrahedra, quarters of the octahedra around the edges, and the octahedron inside.
void add_fcc_cube(Tetrahedra& tetrahedra, const Cubes& cubes, const Triple& p) {
    const auto corner = [&](const Triple& bits) {
        return cubes.corner({p[0] + bits[0], p[1] + bits[1], p[2] + bits[2]});
    };
    const auto face = [&](int axis, Index side) {
        Triple q = p;
        q[axis] += side;
        return cubes.face_center(axis, q);
    };
    // A reflection of the cube turns the orientation.
    const auto add_reflected = [&](Index bits, Index a, Index b, Index c, Index d) {
        bits % 2 == 0 ? tetrahedra.add(a, b, c, d) : tetrahedra.add(a, b, d, c);
    };

    for_each_triple({2, 2, 2}, [&](const Triple& bits) {
        add_reflected(bits[0] + bits[1] + bits[2], corner(bits), face(0, bits[0]), face(1, bits[1]),
                      face(2, bits[2]));
    });
    for_each_triple({3, 2, 2}, [&](const Triple& edge) {
        const auto [axis, u, v] = edge;
        add_reflected(u + v, corner(along(axis, 0, u, v)), corner(along(axis, 1, u, v)),
                      face((axis + 2) % 3, v), face((axis + 1) % 3, u));
    });
    const std::array<Index, 4> ring{face(1, 0), face(2, 0), face(1, 1), face(2, 1)};
    for (int side = 0; side < 4; ++side)
        tetrahedra.add(face(0, 0), face(0, 1), ring[side], ring[(side + 1) % 4]);
}

} // namespace

Mesh kuhn(const std::vector<int>& cells, const std::vector<double>& lengths) {
    check_box(cells, lengths);
    const auto n = static_cast<Index>(cells.size());
    const std::vector<Index> stride = strides(cells);

    Mesh mesh;
    mesh.points.resize(stride[0] * (static_cast<Eigen::Index>(cells[0]) + 1), n);
    std::vector<Index> origins; // lowest vertices of the cubes
    for (Index v = 0; v < mesh.points.rows(); ++v) {
        bool is_origin = true;
        for (Index k = 0, rest = v; k < n; rest %= stride[k++]) {
            const Index i = rest / stride[k];
            const double length = lengths.empty() ? 1.0 : lengths[k];
            mesh.points(v, k) = static_cast<double>(i) / cells[k] * length;
            is_origin = is_origin && i < cells[k];
        }
        if (is_origin)
            origins.push_back(v);
    }

    // Every order of the axes is a path along the edges of a cube from its origin to the opposite
    // corner; the vertices of the path span a simplex.
    std::vector<int> axes(n);
    std::iota(axes.begin(), axes.end(), 0);
    Eigen::Index paths = 1;
    for (Index k = 2; k <= n; ++k)
        paths *= k;
    mesh.simplices.resize(paths * static_cast<Eigen::Index>(origins.size()), n + 1);
    Eigen::Index simplex = 0;
    do {
        Eigen::Matrix<Index, 1, Eigen::Dynamic> path(n + 1);
        path[0] = 0;
        for (Index k = 0; k < n; ++k)
            path[k + 1] = path[k] + stride[axes[k]];
        if (is_odd(axes))
            std::swap(path[0], path[1]);
        for (const Index origin : origins)
            mesh.simplices.row(simplex++) = path.array() + origin;
    } while (std::next_permutation(axes.begin(), axes.end()));
    return mesh;
}

Mesh kuhn(int n, int cells_per_side) {
    check_count("kuhn", "n", n, 1, 12);
    check_count("kuhn", "cells_per_side", cells_per_side, 1);
    return kuhn(std::vector<int>(n, cells_per_side));
}

Mesh bcc(int cells) {
    check_count("bcc", "cells", cells, 1);
    const double c = cells;
    check_sizes("bcc", (c + 1) * (c + 1) * (c + 1) + c * c * c, 12 * c * c * c);

    const Cubes cubes{cells};
    Mesh mesh;
    mesh.points.resize(cubes.corners() + cells * cells * cells, 3);
    cubes.place_corners(mesh.points);
    for_each_triple({cells, cells, cells}, [&](const Triple& p) {
        mesh.points.row(cubes.center(p)) = cubes.place({2 * p[0] + 1, 2 * p[1] + 1, 2 * p[2] + 1});
    });

    Tetrahedra tetrahedra(mesh, 12 * cells * cells * cells);
    for (int axis = 0; axis < 3; ++axis)
        for_each_triple({cells + 1, cells, cells}, [&](const Triple& place) {
            add_bcc_square(tetrahedra, cubes, axis, place);
        });
    return mesh;
}

Mesh fcc(int cells) {
    check_count("fcc", "cells", cells, 1);
    const double c = cells;
    check_sizes("fcc", (c + 1) * (c + 1) * (c + 1) + 3 * (c + 1) * c * c, 24 * c * c * c);

    const Cubes cubes{cells};
    Mesh mesh;
    mesh.points.resize(cubes.corners() + 3 * (cells + 1) * cells * cells, 3);
    cubes.place_corners(mesh.points);
    for (int axis = 0; axis < 3; ++axis)
        for_each_triple({cells + 1, cells, cells}, [&](const Triple& place) {
            const auto [layer, u, v] = place;
            mesh.points.row(cubes.face_center(axis, along(axis, layer, u, v))) =
                cubes.place(along(axis, 2 * layer, 2 * u + 1, 2 * v + 1));
        });

    Tetrahedra tetrahedra(mesh, 24 * cells * cells * cells);
    for_each_triple({cells, cells, cells},
                    [&](const Triple& p) { add_fcc_cube(tetrahedra, cubes, p); });
    return mesh;
}

} // namespace polydec
