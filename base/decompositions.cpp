// SPDX-License-Identifier: MIT
#include "base/decompositions.h"

namespace Eigen {

template class PartialPivLU<polydec::DenseMatrix>;
template class HouseholderQR<polydec::DenseMatrix>;
template class ColPivHouseholderQR<polydec::DenseMatrix>;
template class LLT<polydec::DenseMatrix>;
template class SelfAdjointEigenSolver<polydec::DenseMatrix>;
template class GeneralizedSelfAdjointEigenSolver<polydec::DenseMatrix>;
// members that are templates themselves
template LLT<polydec::DenseMatrix>&
LLT<polydec::DenseMatrix>::compute(const EigenBase<polydec::DenseMatrix>&);
template SelfAdjointEigenSolver<polydec::DenseMatrix>&
SelfAdjointEigenSolver<polydec::DenseMatrix>::compute(const EigenBase<polydec::DenseMatrix>&, int);

} // namespace Eigen

namespace polydec {

namespace {

Eigen::CompleteOrthogonalDecomposition<DenseMatrix> orthogonal(const DenseMatrix& A,
                                                               double threshold) {
    Eigen::CompleteOrthogonalDecomposition<DenseMatrix> factors;
    factors.setThreshold(threshold);
    factors.compute(A);
    return factors;
}

} // namespace

DenseMatrix orthonormal_columns(const DenseMatrix& A) {
    return Eigen::HouseholderQR<DenseMatrix>(A).householderQ() *
           DenseMatrix::Identity(A.rows(), A.cols());
}

DenseMatrix triangular_factor(const DenseMatrix& A) {
    return Eigen::HouseholderQR<DenseMatrix>(A)
        .matrixQR()
        .topRows(A.cols())
        .triangularView<Eigen::Upper>();
}

LinearSolutions least_squares(const DenseMatrix& A, const DenseMatrix& b, double threshold) {
    const auto factors = orthogonal(A, threshold);
    const DenseMatrix basis = factors.matrixZ().transpose();
    return {factors.solve(b),
            factors.colsPermutation() * basis.rightCols(A.cols() - factors.rank())};
}

DenseMatrix pseudo_inverse(const DenseMatrix& A) {
    return orthogonal(A, std::numeric_limits<double>::epsilon()).pseudoInverse();
}

} // namespace polydec
