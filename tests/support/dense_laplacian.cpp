// SPDX-License-Identifier: MIT
#include "tests/support/dense_laplacian.h"

namespace polydec::test {

Vector dense_laplacian_of(const CellComplex& complex, const HodgeStars& stars, int k,
                          const Vector& form) {
    Vector result = Vector::Zero(form.size());
    if (k < complex.dimension()) {
        const SparseMatrix d = derivative(complex, k);
        result += d.transpose() * (dense_star(stars, k + 1) * (d * form));
    }
    if (k > 0) {
        const SparseMatrix d = derivative(complex, k - 1);
        const DenseMatrix mass = dense_star(stars, k);
        const Vector below = d.transpose() * (mass * form);
        result += mass * (d * dense_star(stars, k - 1).llt().solve(below));
    }
    return result;
}

DenseModes dense_modes(const DenseMatrix& A, const DenseMatrix& M) {
    const Eigen::GeneralizedSelfAdjointEigenSolver<DenseMatrix> solver(A, M);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

Vector dense_values(const DenseMatrix& A, const DenseMatrix& M) {
    return Eigen::GeneralizedSelfAdjointEigenSolver<DenseMatrix>(A, M, Eigen::EigenvaluesOnly)
        .eigenvalues();
}

template DenseOf<double> dense_laplacian<double>(const CellComplex&, const HodgeStars&, int);
template DenseOf<long double> dense_laplacian<long double>(const CellComplex&, const HodgeStars&,
                                                           int);
template Eigen::Matrix<double, Eigen::Dynamic, 1> dense_eigenvalues<double>(const CellComplex&,
                                                                            const HodgeStars&, int);
template Eigen::Matrix<long double, Eigen::Dynamic, 1>
dense_eigenvalues<long double>(const CellComplex&, const HodgeStars&, int);

} // namespace polydec::test
