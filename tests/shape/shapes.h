// SPDX-License-Identifier: MIT
#pragma once

#include "tests/support/test.h"

namespace polydec::test {

/// Triangles with lengths, which may branch, and the vertex of the mesh that each vertex is.
struct MeasuredSurface {
    Triangles surface;
    Vector lengths;
    std::vector<Index> vertices;
};

inline MeasuredSurface measured(const Mesh& mesh) {
    const SimplicialComplex complex(mesh.simplices);
    MeasuredSurface result{
        Triangles(complex), edge_lengths(complex, vertex_points(complex, mesh.points)), {}};
    for (Index v = 0; v < complex.size(0); ++v)
        result.vertices.push_back(complex.vertex_number(v));
    return result;
}

/// Where a vertex lies in space.
inline Eigen::Vector3d place(const MeasuredSurface& shape, const Mesh& mesh, Index v) {
    Eigen::Vector3d point = Eigen::Vector3d::Zero();
    point.head(mesh.points.cols()) = mesh.points.row(shape.vertices[v]);
    return point;
}

/// The vertex that lies there.
inline Index vertex_at(const MeasuredSurface& shape, const Mesh& mesh, const Eigen::Vector3d& at) {
    Index v = 0;
    while ((place(shape, mesh, v) - at).norm() > 1e-9)
        ++v;
    return v;
}

/// Triangles in space, each divided into n x n by lines along its sides.
inline Mesh divided(const std::vector<Eigen::Matrix3d>& triangles, int n) {
    std::vector<Eigen::Matrix3d> parts;
    for (const Eigen::Matrix3d& corners : triangles) {
        const auto add = [&](const std::array<Eigen::Vector2i, 3>& steps) {
            Eigen::Matrix3d part;
            for (int i = 0; i < 3; ++i)
                part.col(i) =
                    corners * Eigen::Vector3d(steps[i][0], steps[i][1], n - steps[i].sum()) / n;
            parts.push_back(part);
        };
        for (int i = 0; i < n; ++i)
            for (int j = 0; i + j < n; ++j) {
                const Eigen::Vector2i at(i, j), right(i + 1, j), up(i, j + 1);
                add({at, right, up});
                if (i + j + 1 < n)
                    add({right, at + Eigen::Vector2i::Ones(), up});
            }
    }
    return welded(parts);
}

/// The two triangles of a parallelogram with these sides.
inline void add_parallelogram(std::vector<Eigen::Matrix3d>& triangles, const Eigen::Vector3d& at,
                              const Eigen::Vector3d& u, const Eigen::Vector3d& v) {
    Eigen::Matrix3d lower, upper;
    lower << at, at + u, at + v;
    upper << at + u, at + u + v, at + v;
    triangles.push_back(lower), triangles.push_back(upper);
}

/// Adds the faces of a tetrahedron.
inline void add_tetrahedron(std::vector<Eigen::Matrix3d>& triangles,
                            const std::array<Eigen::Vector3d, 4>& corners) {
    for (int omitted = 0; omitted < 4; ++omitted) {
        triangles.emplace_back();
        for (int i = 0; i < 3; ++i)
            triangles.back().col(i) = corners[(omitted + 1 + i) % 4];
    }
}

/// The surface of the regular tetrahedron of edge 1.
inline Mesh tetrahedron_surface(int n) {
    const double s = 1 / std::sqrt(8.0);
    std::vector<Eigen::Matrix3d> triangles;
    add_tetrahedron(triangles, {Eigen::Vector3d(s, s, s), Eigen::Vector3d(s, -s, -s),
                                Eigen::Vector3d(-s, s, -s), Eigen::Vector3d(-s, -s, s)});
    return divided(triangles, n);
}

/// The surface of the unit cube.
inline Mesh cube_surface(int n) {
    std::vector<Eigen::Matrix3d> triangles;
    for (int axis = 0; axis < 3; ++axis)
        for (int level = 0; level < 2; ++level)
            add_parallelogram(triangles, level * Eigen::Vector3d::Unit(axis),
                              Eigen::Vector3d::Unit((axis + 1) % 3),
                              Eigen::Vector3d::Unit((axis + 2) % 3));
    return divided(triangles, n);
}

/// All squares of the grid of n x n x n unit cubes: four meet at each edge inside.
inline Mesh walls_of_cubes(int n) {
    std::vector<Eigen::Matrix3d> triangles;
    for (int axis = 0; axis < 3; ++axis)
        for (int level = 0; level <= n; ++level)
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) {
                    Eigen::Vector3d at;
                    at[axis] = level, at[(axis + 1) % 3] = i, at[(axis + 2) % 3] = j;
                    add_parallelogram(triangles, at, Eigen::Vector3d::Unit((axis + 1) % 3),
                                      Eigen::Vector3d::Unit((axis + 2) % 3));
                }
    return divided(triangles, 1);
}

/// The surfaces of two regular tetrahedra that touch at a vertex, around which the angles are 2 pi.
inline Mesh touching_tetrahedra() {
    std::vector<Eigen::Matrix3d> triangles;
    for (const double sign : {1.0, -1.0})
        add_tetrahedron(triangles,
                        {Eigen::Vector3d::Zero(), sign * Eigen::Vector3d(1, 1, 0),
                         sign * Eigen::Vector3d(1, 0, 1), sign * Eigen::Vector3d(0, 1, 1)});
    return divided(triangles, 2);
}

/// Hills of several heights over one disk, whose rim they share.
inline Mesh hills(int count, int sectors) {
    std::vector<Eigen::Matrix3d> triangles;
    const auto on_rim = [=](int s) -> Eigen::Vector3d {
        return {std::cos(2 * M_PI * s / sectors), std::sin(2 * M_PI * s / sectors), 0};
    };
    for (int hill = 0; hill < count; ++hill)
        for (int s = 0; s < sectors; ++s) {
            Eigen::Matrix3d sector;
            sector << Eigen::Vector3d(0.1, 0.05, 0.6 * hill - 0.3), on_rim(s), on_rim(s + 1);
            triangles.push_back(sector);
        }
    return divided(triangles, 2);
}

/// A cone of any angle: sectors and rings of triangles around vertex 0, rings 1, 2, .. from it.
/// Vertex 1 + (r - 1) sectors + s lies in ring r at angle s / sectors of all.
inline MeasuredSurface cone(double angle, Index sectors, Index rings) {
    const auto vertex = [=](Index r, Index s) { return 1 + (r - 1) * sectors + s % sectors; };
    Mesh mesh;
    mesh.points.resize(1 + rings * sectors, 2);
    mesh.simplices.resize(sectors * (2 * rings - 1), 3);
    Index t = 0;
    for (Index s = 0; s < sectors; ++s) {
        mesh.simplices.row(t++) << 0, vertex(1, s), vertex(1, s + 1);
        for (Index r = 1; r < rings; ++r) {
            mesh.simplices.row(t++) << vertex(r, s), vertex(r + 1, s), vertex(r + 1, s + 1);
            mesh.simplices.row(t++) << vertex(r, s), vertex(r + 1, s + 1), vertex(r, s + 1);
        }
    }
    const SimplicialComplex complex(mesh.simplices);
    MeasuredSurface result{Triangles(complex), Vector(complex.size(1)), {}};
    for (Index v = 0; v < complex.size(0); ++v)
        result.vertices.push_back(v);
    const auto radius = [=](Index v) { return v == 0 ? 0.0 : double(1 + (v - 1) / sectors); };
    for (Index e = 0; e < complex.size(1); ++e) {
        const Index a = complex.simplices(1)(e, 0), b = complex.simplices(1)(e, 1);
        const bool same = a > 0 && (a - 1) % sectors == (b - 1) % sectors;
        const double half = a == 0 || same ? 0 : angle / double(sectors) / 2;
        result.lengths[e] = std::hypot(radius(a) - radius(b),
                                       2 * std::sin(half) * std::sqrt(radius(a) * radius(b)));
    }
    return result;
}

/// The first vertex of each component.
inline std::vector<Index> one_of_each_component(const Triangles& surface) {
    std::vector<Index> least(std::size_t(surface.vertices()));
    for (Index v = 0; v < surface.vertices(); ++v)
        least[v] = v;
    for (bool changes = true; changes;) {
        changes = false;
        for (Index h = 0; h < 3 * surface.triangles(); ++h) {
            Index &a = least[surface.tail(h)], &b = least[surface.head(h)];
            changes |= a != b;
            a = b = std::min(a, b);
        }
    }
    std::vector<Index> result;
    for (Index v = 0; v < surface.vertices(); ++v)
        if (least[v] == v)
            result.push_back(v);
    return result;
}

} // namespace polydec::test
