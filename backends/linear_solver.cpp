// SPDX-License-Identifier: MIT
#include "backends/linear_solver.h"

#include <algorithm>

namespace polydec {

namespace {

// Laplacians of surfaces have about 7 entries a row, those of solids 15.
constexpr Eigen::Index entries_in_solid_row = 10;

// CG on a million unknowns of a good mesh needs a few thousand steps; what needs more than this
// many will not come to an end in any reasonable time.
constexpr Eigen::Index most_iterations = 50000;

} // namespace

int domain_dimension(const SparseMatrix& A, const MatrixFacts& facts) {
    if (facts.domain_dimension > 0)
        return facts.domain_dimension;
    return A.rows() > 0 && A.nonZeros() / A.rows() >= entries_in_solid_row ? 3 : 2;
}

Index iteration_limit(const LinearSolverOptions& options, Eigen::Index unknowns) {
    if (options.max_iterations > 0)
        return options.max_iterations;
    return static_cast<Index>(std::min(10 * unknowns + 1000, most_iterations));
}

} // namespace polydec
