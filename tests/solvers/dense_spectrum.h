// SPDX-License-Identifier: MIT
#pragma once

#include "base/decompositions.h"
#include "dec/discretization.h"
#include "dec/operators.h"

namespace polydec::test {

/// All eigenvalues of the Laplacian on k-cells, ascending, from dense matrices.
inline Vector dense_spectrum(const Discretization& mesh, int k) {
    const DenseMatrix A = symmetric_laplacian(mesh, k).matrix();
    const DenseMatrix M = star(mesh.volumes(), k).diagonal().asDiagonal();
    return Eigen::GeneralizedSelfAdjointEigenSolver<DenseMatrix>(A, M, Eigen::EigenvaluesOnly)
        .eigenvalues();
}

/// How many of the ascending values lie below the shift.
inline Index number_below(const Vector& values, double shift) {
    return static_cast<Index>((values.array() < shift).count());
}

} // namespace polydec::test
