// SPDX-License-Identifier: MIT
#include "backends/registry.h"
#include "base/decompositions.h"
#include "base/errors.h"
#include "meshes/generate.h"
#include "meshes/generate_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace polydec {

namespace {

/// A pentagon or hexagon: its corners counterclockwise, seen from outside.
struct Face {
    std::array<Index, 6> corners;
    Index size = 0;

    /// How many conditions it takes to be planar.
    Index conditions() const { return size - 3; }
};

/// The dual of a triangulated sphere: a face for every vertex, a corner for every triangle.
std::vector<Face> dual_faces(const Simplices& triangles, Index vertices) {
    // For each vertex v the triangles (v, a, b) around it, not in order yet.
    struct Sector {
        Index triangle, a, b;
    };
    std::vector<std::array<Sector, 6>> sectors(vertices);
    std::vector<Face> faces(vertices);
    for (Index t = 0; t < triangles.rows(); ++t)
        for (int c = 0; c < 3; ++c) {
            const Index v = triangles(t, c);
            sectors[v][faces[v].size++] = {t, triangles(t, (c + 1) % 3), triangles(t, (c + 2) % 3)};
        }

    // Behind (v, a, b) comes (v, b, c).
    for (Index v = 0; v < vertices; ++v) {
        const auto begin = sectors[v].begin(), end = begin + faces[v].size;
        for (auto here = begin; here + 1 < end; ++here)
            std::iter_swap(here + 1, std::find_if(here + 1, end, [&](const Sector& sector) {
                               return sector.a == here->b;
                           }));
        std::transform(begin, end, faces[v].corners.begin(),
                       [](const Sector& sector) { return sector.triangle; });
    }
    return faces;
}

/// How far faces are from planar, and how that changes when corners move on the sphere.
struct Flatness {
    Vector residual;     ///< conditions() values for each face; zero iff all are planar
    SparseMatrix change; ///< what a tangential motion of the corners takes away of it
};

using PerCorner = Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 6, 3>;

/// Orthonormal functions on the corners of a regular polygon that are no affine functions of place:
/// cosine and sine twice around, for a hexagon also alternating signs.
PerCorner bending_modes(Index size) {
    PerCorner modes(size, 3);
    for (Index c = 0; c < size; ++c)
        modes.row(c) << std::sqrt(2.0 / size) * circle_point(2 * c % size, size).transpose(),
            (c % 2 == 0 ? 1.0 : -1.0) / std::sqrt(size);
    return modes;
}

/// Corners X (one a row) are in a plane m . x = 1 iff X m = 1 has a solution: iff e = 1 - X m is 0
/// for the least-squares m. Up to terms of second order, X + dX are in a plane iff R dX m = e, R
/// the projection along X's range; the change of m drops out because R X = 0. As faces are nearly
/// regular, e is 0 iff its components in the bending modes are.
Flatness flatness(const Points& corners, const std::vector<Face>& faces, Index conditions) {
    const std::array modes{bending_modes(5), bending_modes(6)};
    Flatness result{Vector(conditions), SparseMatrix(conditions, 3 * corners.rows())};
    std::vector<Eigen::Triplet<double, Index>> entries;
    entries.reserve(18 * static_cast<std::size_t>(conditions));
    Index row = 0;
    for (const Face& face : faces) {
        PerCorner X(face.size, 3);
        for (Index c = 0; c < face.size; ++c)
            X.row(c) = corners.row(face.corners[c]);
        const Vector ones = Vector::Ones(face.size);
        const Eigen::Vector3d m = least_squares(X, ones).shortest;
        const PerCorner Q = orthonormal_columns(X);
        const PerCorner& B = modes[face.size - 5];
        const PerCorner RB = B - Q * (Q.transpose() * B);

        result.residual.segment(row, face.conditions()) =
            B.leftCols(face.conditions()).transpose() * (ones - X * m);
        for (Index c = 0; c < face.size; ++c) {
            const Eigen::Vector3d x = X.row(c);
            const Eigen::Vector3d tangential = m - m.dot(x) * x;
            for (Index i = 0; i < face.conditions(); ++i)
                for (int axis = 0; axis < 3; ++axis)
                    entries.emplace_back(row + i, 3 * face.corners[c] + axis,
                                         RB(c, i) * tangential[axis]);
        }
        row += face.conditions();
    }
    result.change.setFromTriplets(entries.begin(), entries.end());
    return result;
}

/// Moves the corners on the unit sphere until the faces are planar: Gauss-Newton steps, each the
/// least motion that flattens to first order. Rounding ends the progress.
void flatten(Points& corners, const std::vector<Face>& faces) {
    Index conditions = 0;
    for (const Face& face : faces)
        conditions += face.conditions();

    // An engine that is always there, so that the mesh is the same on every machine. The Gram
    // matrix is regular: inscribed polyhedra with three faces at every corner have as many degrees
    // of freedom as edges minus corners, plus six (Rivin 1996).
    const auto solver = make_linear_solver("eigen.ldlt");
    SparseMatrix adjoint;
    Flatness now = flatness(corners, faces, conditions);
    double error = now.residual.cwiseAbs().maxCoeff(), progress = 1.0;
    for (int i = 0; i < 20 && error > 2e-15; ++i) {
        // As long as it serves well, the last factorization is taken again: most time goes there.
        if (progress > 0.1) {
            adjoint = now.change.transpose();
            solver->factorize(SparseMatrix(now.change * adjoint),
                              {.symmetry = Symmetry::symmetric,
                               .definiteness = Definiteness::positive,
                               .domain_dimension = 2});
        }
        const Vector motion = adjoint * solver->solve(now.residual);

        Points moved = corners + Eigen::Map<const Points>(motion.data(), corners.rows(), 3);
        moved.rowwise().normalize();
        Flatness next = flatness(moved, faces, conditions);
        const double next_error = next.residual.cwiseAbs().maxCoeff();
        if (error < 1e-12 && next_error >= error)
            break;
        corners = std::move(moved);
        now = std::move(next);
        progress = next_error / std::exchange(error, next_error);
    }
    if (!(error < 1e-13))
        throw SolverFailure(fmt::format("goldberg: the faces do not become planar, the error stays "
                                        "at {:.1e}; use another frequency",
                                        error));
}

} // namespace

Mesh goldberg(int frequency) {
    check_count("goldberg", "frequency", frequency, 1, 64);
    const Mesh sphere = icosphere(frequency);
    const std::vector<Face> faces =
        dual_faces(sphere.simplices, static_cast<Index>(sphere.points.rows()));

    Mesh mesh;
    mesh.points.resize(sphere.simplices.rows(), 3);
    for (Index t = 0; t < mesh.points.rows(); ++t) {
        const auto corner = [&](int c) { return sphere.points.row(sphere.simplices(t, c)); };
        mesh.points.row(t) = (corner(0) + corner(1) + corner(2)).normalized();
    }
    flatten(mesh.points, faces);

    mesh.simplices.resize(40 * frequency * frequency - 4, 3);
    Index triangle = 0;
    for (const Face& face : faces)
        for (Index c = 2; c < face.size; ++c)
            mesh.simplices.row(triangle++) << face.corners[0], face.corners[c - 1], face.corners[c];
    return mesh;
}

} // namespace polydec
