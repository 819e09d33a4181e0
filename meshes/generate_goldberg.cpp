// SPDX-License-Identifier: MIT
#include "meshes/generate_goldberg.h"

#include "backends/registry.h"
#include "base/errors.h"
#include "meshes/generate_parts.h"
#include "meshes/generate_spheres.h"

#include <Eigen/QR>
#include <fmt/format.h>

#include <algorithm>
#include <array>
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

/// Corners X (one a row) are in a plane m . x = 1 iff X m = 1 has a solution: iff N^T 1 = 0, the
/// columns of N being an orthonormal basis of the complement of X's range. Up to terms of second
/// order, corners X + dX are in a plane iff N^T dX m = N^T 1 for the m nearest to a solution;
/// dropping the change of m is right because N^T X = 0. Which basis N is, does not matter.
Flatness flatness(const Points& corners, const std::vector<Face>& faces, Index conditions) {
    Flatness result{Vector(conditions), SparseMatrix(conditions, 3 * corners.rows())};
    std::vector<Eigen::Triplet<double, Index>> entries;
    entries.reserve(18 * static_cast<std::size_t>(conditions));
    Index row = 0;
    for (const Face& face : faces) {
        Eigen::Matrix<double, Eigen::Dynamic, 3, 0, 6, 3> X(face.size, 3);
        for (Index c = 0; c < face.size; ++c)
            X.row(c) = corners.row(face.corners[c]);
        const Vector ones = Vector::Ones(face.size);
        const Eigen::HouseholderQR<decltype(X)> qr(X);
        const Eigen::Vector3d m = qr.solve(ones);
        const DenseMatrix Q = qr.householderQ() * DenseMatrix::Identity(face.size, face.size);
        const auto N = Q.rightCols(face.conditions());

        result.residual.segment(row, face.conditions()) = N.transpose() * ones;
        for (Index c = 0; c < face.size; ++c) {
            const Eigen::Vector3d x = X.row(c);
            const Eigen::Vector3d tangential = m - m.dot(x) * x;
            for (Index i = 0; i < face.conditions(); ++i)
                for (int axis = 0; axis < 3; ++axis)
                    entries.emplace_back(row + i, 3 * face.corners[c] + axis,
                                         N(c, i) * tangential[axis]);
        }
        row += face.conditions();
    }
    result.change.setFromTriplets(entries.begin(), entries.end());
    return result;
}

/// Moves the corners on the unit sphere until the faces are planar: Gauss-Newton steps, each the
/// least motion that flattens to first order. Quadratic convergence; rounding ends it.
void flatten(Points& corners, const std::vector<Face>& faces) {
    Index conditions = 0;
    for (const Face& face : faces)
        conditions += face.conditions();

    // An engine that is always there, so that the mesh is the same on every machine. The Gram
    // matrix is regular: inscribed polyhedra with three faces at every corner have as many degrees
    // of freedom as edges minus corners, plus six (Rivin 1996).
    const auto solver = make_linear_solver("eigen.ldlt");
    Flatness now = flatness(corners, faces, conditions);
    double error = now.residual.cwiseAbs().maxCoeff();
    for (int i = 0; i < 12 && error > 1e-15; ++i) {
        const SparseMatrix adjoint = now.change.transpose();
        solver->factorize(SparseMatrix(now.change * adjoint),
                          {.symmetry = Symmetry::symmetric,
                           .definiteness = Definiteness::positive,
                           .domain_dimension = 2});
        const Vector motion = adjoint * solver->solve(now.residual);

        Points moved = corners + Eigen::Map<const Points>(motion.data(), corners.rows(), 3);
        moved.rowwise().normalize();
        Flatness next = flatness(moved, faces, conditions);
        const double next_error = next.residual.cwiseAbs().maxCoeff();
        if (!(next_error < error))
            break;
        corners = std::move(moved);
        now = std::move(next);
        error = next_error;
    }
    if (!(error < 1e-13))
        throw SolverFailure(fmt::format("goldberg: the faces are not planar, the error stays at "
                                        "{:.1e}; take another frequency",
                                        error));
}

} // namespace

Mesh goldberg(int frequency) {
    check_count("goldberg", "frequency", frequency, 1, 128);
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
