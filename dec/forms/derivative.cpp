// SPDX-License-Identifier: MIT
#include "dec/forms/cochain.h"

namespace polydec {

SparseMatrix derivative(const CellComplex& complex, int k) {
    return complex.incidences(k).real_matrix();
}

SparseMatrix dual_derivative(const CellComplex& complex, int j) {
    const int k = complex.dimension() - j - 1;
    const double sign = k % 2 == 0 ? -1 : 1;
    return sign * SparseMatrix(derivative(complex, k).transpose());
}

} // namespace polydec
