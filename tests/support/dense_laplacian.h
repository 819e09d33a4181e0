// SPDX-License-Identifier: MIT
#pragma once

#include "base/decompositions.h"
#include "dec/discretization/discretization.h"
#include "tests/support/extended.h"

namespace polydec::test {

/// star_k Delta_k of a k-form, with every star a dense matrix.
Vector dense_laplacian_of(const CellComplex& complex, const HodgeStars& stars, int k,
                          const Vector& form);

/// All eigenvalues of the Laplacian on k-cells, ascending.
ExtendedVector extended_eigenvalues(const CellComplex& complex, const HodgeStars& stars, int k);

/// The same from dense matrices of doubles with diagonal stars, and how many values are below a
/// shift.
Vector dense_spectrum(const Discretization& mesh, int k);
Index number_below(const Vector& values, double shift);

struct DenseModes {
    Vector values;     ///< ascending
    DenseMatrix forms; ///< a column each, orthonormal in M
};

/// All of A x = lambda M x.
DenseModes dense_modes(const DenseMatrix& A, const DenseMatrix& M);
Vector dense_values(const DenseMatrix& A, const DenseMatrix& M);

} // namespace polydec::test
