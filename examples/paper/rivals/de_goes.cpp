// SPDX-License-Identifier: MIT
#include "examples/paper/rivals/de_goes.h"

#include "base/errors.h"
#include "examples/paper/rivals/polygon_faces.h"

#include <Eigen/Dense>

#include <cmath>
#include <string>

namespace polydec::paper {

namespace {

/// U: column i is n cross b_i over the area.
DenseMatrix sharp(const Polygon& polygon, const Eigen::Vector3d& area) {
    const Polygon B = midpoints(polygon);
    DenseMatrix U(3, B.rows());
    for (Eigen::Index i = 0; i < B.rows(); ++i)
        U.col(i) = area.cross(B.row(i).transpose()) / area.squaredNorm();
    return U;
}

/// V: row i is edge i without its normal component.
DenseMatrix flat(const Polygon& polygon, const Eigen::Vector3d& normal) {
    const Polygon E = edges(polygon);
    return E - E * normal * normal.transpose();
}

DenseMatrix stiffness_of_face(const Polygon& polygon, double lambda) {
    const Eigen::Vector3d area = area_vector(polygon);
    const DenseMatrix U = sharp(polygon, area);
    const DenseMatrix V = flat(polygon, area.normalized());
    const DenseMatrix P = DenseMatrix::Identity(polygon.rows(), polygon.rows()) - V * U;
    const DenseMatrix D = differences(static_cast<Index>(polygon.rows()));
    const DenseMatrix product = area.norm() * U.transpose() * U + lambda * P.transpose() * P;
    return D.transpose() * product * D;
}

} // namespace

PolygonLaplacian de_goes(const PolygonMesh& mesh, double lambda) {
    if (!(std::isfinite(lambda) && lambda >= 0))
        throw InvalidInput("lambda is " + std::to_string(lambda) +
                           "; expected at least 0, such as 1");
    check_surface(mesh);
    const auto local = [lambda](const Polygon& polygon) {
        return stiffness_of_face(polygon, lambda);
    };
    return {assemble(mesh, local), equal_shares(mesh)};
}

} // namespace polydec::paper
