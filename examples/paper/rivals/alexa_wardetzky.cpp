// SPDX-License-Identifier: MIT
#include "examples/paper/rivals/alexa_wardetzky.h"

#include "base/errors.h"
#include "examples/paper/rivals/polygon_faces.h"

#include <Eigen/Dense>

#include <cmath>
#include <string>

namespace polydec::paper {

namespace {

/// C C^T, the projector to the kernel of E^T.
DenseMatrix kernel_projector(const Polygon& polygon, const Eigen::Vector3d& normal) {
    Eigen::Matrix<double, 3, 2> tangents;
    tangents.col(0) = normal.unitOrthogonal();
    tangents.col(1) = normal.cross(tangents.col(0));

    const DenseMatrix E = edges(polygon) * tangents;
    const DenseMatrix identity = DenseMatrix::Identity(E.rows(), E.rows());
    return identity - E * (E.transpose() * E).inverse() * E.transpose();
}

DenseMatrix local_stiffness(const Polygon& polygon, double lambda) {
    const Eigen::Vector3d area = area_vector(polygon);
    const DenseMatrix B = midpoints(polygon);
    const DenseMatrix D = differences(static_cast<Index>(polygon.rows()));
    const DenseMatrix product =
        B * B.transpose() / area.norm() + lambda * kernel_projector(polygon, area.normalized());
    return D.transpose() * product * D;
}

} // namespace

PolygonLaplacian alexa_wardetzky(const PolygonMesh& mesh, double lambda) {
    if (!(std::isfinite(lambda) && lambda >= 0))
        throw InvalidInput("lambda is " + std::to_string(lambda) +
                           "; expected at least 0, such as 2");
    check_surface(mesh);
    const auto local = [lambda](const Polygon& polygon) {
        return local_stiffness(polygon, lambda);
    };
    return {assemble(mesh, local), equal_shares(mesh)};
}

} // namespace polydec::paper
