// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

#include <limits>

// Eigen's decompositions of dense matrices, compiled once: otherwise each file that uses one would
// take seconds longer to compile.
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

/// Q of A = Q R by Householder reflections. A has no fewer rows than columns; Q has as many
/// columns, orthonormal even if the columns of A are linearly dependent.
DenseMatrix orthonormal_columns(const DenseMatrix& A);

/// R of A = Q R, upper triangular; the product of its diagonal is, up to sign, the volume spanned
/// by A's columns.
DenseMatrix triangular_factor(const DenseMatrix& A);

/// Minimizers x of |A x - b|: the shortest one for each column of b, and an orthonormal basis of
/// the kernel. Pivots below `threshold` times the largest are 0.
struct LinearSolutions {
    DenseMatrix shortest, kernel;
};
LinearSolutions least_squares(const DenseMatrix& A, const DenseMatrix& b,
                              double threshold = std::numeric_limits<double>::epsilon());

/// The Moore-Penrose pseudoinverse, by the same pivots.
DenseMatrix pseudo_inverse(const DenseMatrix& A);

} // namespace polydec
