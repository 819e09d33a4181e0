// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

/// Dense matrices with eleven bits more than what is tested; their decompositions are compiled
/// once.
namespace polydec::test {

using Extended = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
using ExtendedVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

/// Of symmetric A, ascending.
ExtendedVector extended_eigenvalues(const Extended& A);

/// Of A x = lambda M x, M positive definite, ascending.
ExtendedVector extended_eigenvalues(const Extended& A, const Extended& M);

struct ExtendedSolution {
    Extended X;                       ///< A X = B
    long double reciprocal_condition; ///< an estimate
};
ExtendedSolution solve_extended(const Extended& A, const Extended& B);

} // namespace polydec::test
