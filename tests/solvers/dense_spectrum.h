// SPDX-License-Identifier: MIT
#pragma once

#include "tests/support/test.h"

namespace polydec::test {

/// All eigenvalues of the Laplacian on k-cells, ascending, from dense matrices.
inline Vector dense_spectrum(const Discretization& mesh, int k) {
    return dense_values(DenseMatrix(symmetric_laplacian(mesh, k).matrix()),
                        star(mesh.volumes(), k).diagonal().asDiagonal());
}

/// How many of the ascending values lie below the shift.
inline Index number_below(const Vector& values, double shift) {
    return static_cast<Index>((values.array() < shift).count());
}

} // namespace polydec::test
