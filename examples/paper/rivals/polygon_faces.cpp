// SPDX-License-Identifier: MIT
#include "examples/paper/rivals/polygon_faces.h"

#include "base/errors.h"

#include <Eigen/Geometry>

#include <string>

namespace polydec::paper {

namespace {

constexpr double least_relative_area = 1e-12;

[[noreturn]] void refuse_face(Index f, const std::string& what) {
    throw InvalidInput("face " + std::to_string(f) + " " + what);
}

void check_points(const PolygonMesh& mesh) {
    if (mesh.points.cols() != 3)
        throw InvalidInput("the points have " + std::to_string(mesh.points.cols()) +
                           " coordinates; expected 3; give planar meshes z = 0");
    for (Index v = 0; v < mesh.points.rows(); ++v)
        if (!mesh.points.row(v).allFinite())
            throw InvalidInput("vertex " + std::to_string(v) +
                               " has a coordinate that is not finite");
}

void check_face(const PolygonMesh& mesh, Index f) {
    const auto around = mesh.face(f);
    if (around.size() < 3)
        refuse_face(f, "has " + std::to_string(around.size()) + " corners; expected 3 or more");
    for (std::size_t i = 0; i < around.size(); ++i)
        if (around[i] == around[(i + 1) % around.size()])
            refuse_face(f, "has the vertex " + std::to_string(around[i]) +
                               " twice in a row; leave one out");

    const Polygon polygon = positions(mesh, f);
    const double longest = edges(polygon).rowwise().squaredNorm().maxCoeff();
    if (!(area_vector(polygon).norm() > least_relative_area * longest))
        refuse_face(f, "has no area; leave it out or move its corners");
}

void check_vertices_used(const PolygonMesh& mesh) {
    std::vector<char> used(static_cast<std::size_t>(mesh.points.rows()), 0);
    for (const Index v : mesh.corners)
        used[static_cast<std::size_t>(v)] = 1;
    for (std::size_t v = 0; v < used.size(); ++v)
        if (used[v] == 0)
            throw InvalidInput("vertex " + std::to_string(v) + " is in no face; leave it out");
}

} // namespace

void check_surface(const PolygonMesh& mesh) {
    check_polygons(mesh);
    check_points(mesh);
    for (Index f = 0; f < mesh.size(); ++f)
        check_face(mesh, f);
    check_vertices_used(mesh);
}

Polygon positions(const PolygonMesh& mesh, Index f) {
    const auto around = mesh.face(f);
    Polygon polygon(around.size(), 3);
    for (std::size_t i = 0; i < around.size(); ++i)
        polygon.row(static_cast<Index>(i)) = mesh.points.row(around[i]);
    return polygon;
}

Eigen::Vector3d area_vector(const Polygon& polygon) {
    // seen from the first corner, so that far from the origin no digits are lost
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (Eigen::Index i = 1; i + 1 < polygon.rows(); ++i)
        sum += (polygon.row(i) - polygon.row(0))
                   .transpose()
                   .cross((polygon.row(i + 1) - polygon.row(0)).transpose());
    return sum / 2;
}

Polygon edges(const Polygon& polygon) {
    Polygon E(polygon.rows(), 3);
    for (Eigen::Index i = 0; i < polygon.rows(); ++i)
        E.row(i) = polygon.row((i + 1) % polygon.rows()) - polygon.row(i);
    return E;
}

Polygon midpoints(const Polygon& polygon) {
    const Polygon centered = polygon.rowwise() - polygon.colwise().mean();
    return centered + edges(polygon) / 2;
}

DenseMatrix differences(Index n) {
    DenseMatrix D = -DenseMatrix::Identity(n, n);
    for (Index i = 0; i < n; ++i)
        D(i, (i + 1) % n) += 1;
    return D;
}

SparseMatrix assemble(const PolygonMesh& mesh,
                      const std::function<DenseMatrix(const Polygon&)>& local) {
    std::vector<Eigen::Triplet<double, Index>> entries;
    for (Index f = 0; f < mesh.size(); ++f) {
        const auto around = mesh.face(f);
        const DenseMatrix A = local(positions(mesh, f));
        for (std::size_t i = 0; i < around.size(); ++i)
            for (std::size_t j = 0; j < around.size(); ++j)
                entries.emplace_back(around[i], around[j],
                                     A(static_cast<Index>(i), static_cast<Index>(j)));
    }
    SparseMatrix sum(mesh.points.rows(), mesh.points.rows());
    sum.setFromTriplets(entries.begin(), entries.end());
    return sum;
}

SparseMatrix equal_shares(const PolygonMesh& mesh) {
    Vector shares = Vector::Zero(mesh.points.rows());
    for (Index f = 0; f < mesh.size(); ++f) {
        const auto around = mesh.face(f);
        const double area = area_vector(positions(mesh, f)).norm();
        for (const Index v : around)
            shares[v] += area / static_cast<double>(around.size());
    }
    return SparseMatrix(shares.asDiagonal());
}

} // namespace polydec::paper
