// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

#include <limits>

// Eigen's decompositions of dense matrices, compiled once: each file that uses one would take
// seconds more to compile.
namespace Eigen {

extern template class PartialPivLU<polydec::DenseMatrix>;
extern template class HouseholderQR<polydec::DenseMatrix>;
extern template class ColPivHouseholderQR<polydec::DenseMatrix>;
extern template class LLT<polydec::DenseMatrix>;
extern template class SelfAdjointEigenSolver<polydec::DenseMatrix>;
extern template class GeneralizedSelfAdjointEigenSolver<polydec::DenseMatrix>;
// members that are templates themselves
extern template LLT<polydec::DenseMatrix>&
LLT<polydec::DenseMatrix>::compute(const EigenBase<polydec::DenseMatrix>&);
extern template SelfAdjointEigenSolver<polydec::DenseMatrix>&
SelfAdjointEigenSolver<polydec::DenseMatrix>::compute(const EigenBase<polydec::DenseMatrix>&, int);

} // namespace Eigen

namespace polydec {

/// A = Q R by Householder's reflections; A has no fewer rows than columns, and Q as many columns,
/// orthonormal even where those of A depend on each other.
DenseMatrix orthonormal_columns(const DenseMatrix& A);

/// R of that, upper triangular; the product of its diagonal is the volume that A's columns span,
/// but for the sign.
DenseMatrix triangular_factor(const DenseMatrix& A);

/// The x for which |A x - b| is least: the shortest, a column for each of b, and an orthonormal
/// basis of what may be added. Pivots below `threshold` times the largest are 0.
struct LinearSolutions {
    DenseMatrix shortest, kernel;
};
LinearSolutions least_squares(const DenseMatrix& A, const DenseMatrix& b,
                              double threshold = std::numeric_limits<double>::epsilon());

/// Moore and Penrose's, by the same pivots.
DenseMatrix pseudo_inverse(const DenseMatrix& A);

} // namespace polydec
