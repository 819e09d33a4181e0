// SPDX-License-Identifier: MIT
#include "examples/paper/rivals/bunge_virtual_vertex.h"

#include "base/errors.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <string>

namespace polydec::paper {

namespace {

constexpr double flatness = 1e-10;
constexpr double least_area_of_triangles = 1e-12;

using Entries = std::vector<Eigen::Triplet<double, Index>>;

/// Minimizer z of the sum over the edges e from p to q of |p x q + e x z|^2 / 4: the sum of
/// (|e|^2 - e e^T) z equals the sum of e x (p x q).
Eigen::Vector3d area_minimizer(const Polygon& polygon) {
    const Polygon E = edges(polygon);
    Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
    Eigen::Vector3d b = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 0; i < E.rows(); ++i) {
        const Eigen::Vector3d e = E.row(i), p = polygon.row(i);
        A += e.squaredNorm() * Eigen::Matrix3d::Identity() - e * e.transpose();
        b += e.cross(p.cross(e));
    }
    return A.ldlt().solve(b);
}

struct Triangle {
    std::array<Index, 3> vertices;
    std::array<Eigen::Vector3d, 3> positions;
};

/// Edge i is the one opposite to corner i.
Eigen::Vector3d edge(const Triangle& triangle, std::size_t i) {
    return triangle.positions[(i + 2) % 3] - triangle.positions[(i + 1) % 3];
}

double area(const Triangle& triangle) {
    return edge(triangle, 0).cross(edge(triangle, 1)).norm() / 2;
}

void add_triangle(Entries& stiffness, Entries& mass, const Triangle& triangle) {
    const double size = area(triangle);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            const Index row = triangle.vertices[i], column = triangle.vertices[j];
            stiffness.emplace_back(row, column,
                                   edge(triangle, i).dot(edge(triangle, j)) / (4 * size));
            mass.emplace_back(row, column, i == j ? size / 6 : size / 12);
        }
}

void check_area(const Triangle& triangle, Index f) {
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i)
        longest = std::max(longest, edge(triangle, i).squaredNorm());
    if (!(area(triangle) > least_area_of_triangles * longest))
        throw InvalidInput("face " + std::to_string(f) + " has its virtual vertex in line with " +
                           "its edge from vertex " + std::to_string(triangle.vertices[0]) + " to " +
                           std::to_string(triangle.vertices[1]) + "; split the face");
}

/// The matrix of the polygons, from the matrix of the triangles.
SparseMatrix restricted(const Entries& entries, const SparseMatrix& P) {
    SparseMatrix A(P.rows(), P.rows());
    A.setFromTriplets(entries.begin(), entries.end());
    return SparseMatrix(P.transpose()) * A * P;
}

} // namespace

Vector virtual_vertex_weights(const Polygon& polygon) {
    const auto n = polygon.rows();
    const Polygon centered = polygon.rowwise() - polygon.colwise().mean();

    // the least w = 1/n + v with v^T centered = z: v in the range of centered
    Eigen::JacobiSVD<DenseMatrix> factors(centered.transpose(),
                                          Eigen::ComputeThinU | Eigen::ComputeThinV);
    factors.setThreshold(flatness);
    const Vector away = factors.solve(area_minimizer(centered));
    return Vector::Constant(n, 1.0 / static_cast<double>(n)) + away;
}

SparseMatrix prolongation(const PolygonMesh& mesh) {
    const auto vertices = static_cast<Index>(mesh.points.rows());
    Entries entries;
    for (Index v = 0; v < vertices; ++v)
        entries.emplace_back(v, v, 1.0);
    for (Index f = 0; f < mesh.size(); ++f) {
        const Vector w = virtual_vertex_weights(positions(mesh, f));
        const auto around = mesh.face(f);
        for (std::size_t i = 0; i < around.size(); ++i)
            entries.emplace_back(vertices + f, around[i], w[static_cast<Index>(i)]);
    }
    SparseMatrix P(vertices + mesh.size(), vertices);
    P.setFromTriplets(entries.begin(), entries.end());
    return P;
}

PolygonLaplacian bunge_virtual_vertex(const PolygonMesh& mesh) {
    check_surface(mesh);
    const SparseMatrix P = prolongation(mesh);
    const Points points = P * mesh.points;
    const auto vertices = static_cast<Index>(mesh.points.rows());

    Entries stiffness, mass;
    for (Index f = 0; f < mesh.size(); ++f) {
        const auto around = mesh.face(f);
        for (std::size_t i = 0; i < around.size(); ++i) {
            Triangle triangle{{around[i], around[(i + 1) % around.size()], vertices + f}, {}};
            for (std::size_t j = 0; j < 3; ++j)
                triangle.positions[j] = points.row(triangle.vertices[j]);
            check_area(triangle, f);
            add_triangle(stiffness, mass, triangle);
        }
    }
    return {restricted(stiffness, P), restricted(mass, P)};
}

} // namespace polydec::paper
