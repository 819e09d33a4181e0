// SPDX-License-Identifier: MIT
#include "solvers/vertex_shares.h"

#include "dec/metric/dual_parts.h"

namespace polydec {

SparseMatrix shares_of_vertices(const Discretization& mesh) {
    const int n = mesh.dimension();
    const SparseMatrix parts = dual_parts(
        mesh.geometry(),
        mesh.stars()[1].is_diagonal() ? mesh.geometry().centers() : Centers::centroids(), 0, n - 1);
    const SparseMatrix pieces = mesh.merging().diamond(n - 1).cast<double>().cwiseAbs();
    return SparseMatrix(pieces * parts).transpose();
}

SparseMatrix shares_of_vertices(const CellComplex& complex, const HodgeStars& stars) {
    const int n = complex.dimension();
    SparseMatrix vertices(complex.size(n - 1), complex.size(n - 1));
    vertices.setIdentity();
    for (int k = n - 2; k >= 0; --k) {
        SparseMatrix faces = complex.incidences(k).real_matrix().cwiseAbs();
        for (const auto& [cell, face] : complex.canceled(k))
            faces.coeffRef(cell, face) = 1;
        vertices = SparseMatrix(vertices * faces);
    }
    vertices.coeffs().setOnes();
    const Vector counts = vertices * Vector::Ones(vertices.cols());
    const Vector shares = stars.volumes().primal(n - 1).cwiseQuotient(counts);
    return SparseMatrix(shares.asDiagonal() * vertices).transpose();
}

} // namespace polydec
