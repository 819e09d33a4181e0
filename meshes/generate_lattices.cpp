// SPDX-License-Identifier: MIT
#include "meshes/generate.h"
#include "meshes/generate_parts.h"

#include <array>

namespace polydec {

namespace {

using Triple = std::array<Index, 3>;

double corners_of_cubes(const std::vector<int>& counts) {
    double result = 1.0;
    for (const int count : counts)
        result *= count + 1.0;
    return result;
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
    Triple cells;
    double edge;

    Index cube_count() const { return cells[0] * cells[1] * cells[2]; }
    Index corner_count() const { return (cells[0] + 1) * (cells[1] + 1) * (cells[2] + 1); }

    Index corner(const Triple& p) const {
        return (p[0] * (cells[1] + 1) + p[1]) * (cells[2] + 1) + p[2];
    }
    Index center(const Triple& p) const {
        return corner_count() + (p[0] * cells[1] + p[1]) * cells[2] + p[2];
    }

    /// Center of the square at the low end of cube p along an axis; p may be one beyond the last.
    Index face_center(int axis, const Triple& p) const {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        Index result = corner_count() + (p[axis] * cells[u] + p[u]) * cells[v] + p[v];
        for (int before = 0; before < axis; ++before)
            result += cube_count() / cells[before] * (cells[before] + 1);
        return result;
    }

    /// Numbers of squares across an axis: their layers along it, then along the axes that follow.
    Triple squares(int axis) const {
        return {cells[axis] + 1, cells[(axis + 1) % 3], cells[(axis + 2) % 3]};
    }

    /// Place of a point given in half cubes; the ends of the box come out to the last bit.
    Eigen::RowVector3d place(const Triple& halves) const {
        Eigen::RowVector3d result;
        for (int k = 0; k < 3; ++k)
            result[k] = halves[k] / (2.0 * cells[k]) * (cells[k] * edge);
        return result;
    }
    void place_corners(Points& points) const {
        for_each_triple({cells[0] + 1, cells[1] + 1, cells[2] + 1}, [&](const Triple& p) {
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
    } else if (layer == cubes.cells[axis]) {
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

Mesh bcc(const std::vector<int>& counts, double edge) {
    const double boxes = check_cubes("bcc", counts, 3, edge);
    check_sizes("bcc", boxes + corners_of_cubes(counts), 12 * boxes);

    const Cubes cubes{{counts[0], counts[1], counts[2]}, edge};
    Mesh mesh;
    mesh.points.resize(cubes.corner_count() + cubes.cube_count(), 3);
    cubes.place_corners(mesh.points);
    for_each_triple(cubes.cells, [&](const Triple& p) {
        mesh.points.row(cubes.center(p)) = cubes.place({2 * p[0] + 1, 2 * p[1] + 1, 2 * p[2] + 1});
    });

    Tetrahedra tetrahedra(mesh, 12 * cubes.cube_count());
    for (int axis = 0; axis < 3; ++axis)
        for_each_triple(cubes.squares(axis), [&](const Triple& place) {
            add_bcc_square(tetrahedra, cubes, axis, place);
        });
    return mesh;
}

Mesh bcc(int cells) {
    check_count("bcc", "cells", cells, 1);
    return bcc({cells, cells, cells}, 1.0 / cells);
}

Mesh fcc(const std::vector<int>& counts, double edge) {
    const double boxes = check_cubes("fcc", counts, 3, edge);
    const Cubes cubes{{counts[0], counts[1], counts[2]}, edge};
    double squares = 0.0;
    for (int axis = 0; axis < 3; ++axis)
        squares += boxes / counts[axis] * (counts[axis] + 1.0);
    check_sizes("fcc", squares + corners_of_cubes(counts), 24 * boxes);

    Mesh mesh;
    mesh.points.resize(cubes.corner_count() + static_cast<Eigen::Index>(squares), 3);
    cubes.place_corners(mesh.points);
    for (int axis = 0; axis < 3; ++axis)
        for_each_triple(cubes.squares(axis), [&](const Triple& place) {
            const auto [layer, u, v] = place;
            mesh.points.row(cubes.face_center(axis, along(axis, layer, u, v))) =
                cubes.place(along(axis, 2 * layer, 2 * u + 1, 2 * v + 1));
        });

    Tetrahedra tetrahedra(mesh, 24 * cubes.cube_count());
    for_each_triple(cubes.cells, [&](const Triple& p) { add_fcc_cube(tetrahedra, cubes, p); });
    return mesh;
}

Mesh fcc(int cells) {
    check_count("fcc", "cells", cells, 1);
    return fcc({cells, cells, cells}, 1.0 / cells);
}

} // namespace polydec
