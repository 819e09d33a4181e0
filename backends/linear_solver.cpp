// SPDX-License-Identifier: MIT
#include "backends/linear_solver.h"

namespace polydec {

namespace {

// Laplacians of surfaces have about 7 entries a row, those of solids 15.
constexpr Eigen::Index entries_in_solid_row = 10;

} // namespace

int domain_dimension(const SparseMatrix& A, const MatrixFacts& facts) {
    if (facts.domain_dimension > 0)
        return facts.domain_dimension;
    return A.rows() > 0 && A.nonZeros() / A.rows() >= entries_in_solid_row ? 3 : 2;
}

} // namespace polydec
