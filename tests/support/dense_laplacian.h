// SPDX-License-Identifier: MIT
#pragma once

#include "base/decompositions.h"
#include "complex/cell_complex.h"
#include "dec/forms/cochain.h"
#include "dec/stars/star.h"

namespace polydec::test {

template <class Scalar>
using DenseOf = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

/// star_k.
template <class Scalar = double>
DenseOf<Scalar> dense_star(const HodgeStars& stars, int k) {
    return DenseMatrix(stars[k].matrix()).cast<Scalar>();
}

/// star_k Delta_k of a k-form, with every star a dense matrix.
Vector dense_laplacian_of(const CellComplex& complex, const HodgeStars& stars, int k,
                          const Vector& form);

/// star_k Delta_k with every star a dense matrix.
template <class Scalar = double>
DenseOf<Scalar> dense_laplacian(const CellComplex& complex, const HodgeStars& stars, int k) {
    DenseOf<Scalar> A = DenseOf<Scalar>::Zero(complex.size(k), complex.size(k));
    if (k < complex.dimension()) {
        const DenseOf<Scalar> d = DenseMatrix(derivative(complex, k)).cast<Scalar>();
        A += d.transpose() * dense_star<Scalar>(stars, k + 1) * d;
    }
    if (k > 0) {
        const DenseOf<Scalar> d = DenseMatrix(derivative(complex, k - 1)).cast<Scalar>();
        const DenseOf<Scalar> B = dense_star<Scalar>(stars, k) * d;
        const DenseOf<Scalar> below = dense_star<Scalar>(stars, k - 1);
        A +=
            B * below.ldlt().solve(DenseOf<Scalar>(B.transpose())); // also where it is not positive
    }
    return A;
}

/// All eigenvalues of the Laplacian on k-cells, ascending.
template <class Scalar = double>
Eigen::Matrix<Scalar, Eigen::Dynamic, 1> dense_eigenvalues(const CellComplex& complex,
                                                           const HodgeStars& stars, int k) {
    return Eigen::GeneralizedSelfAdjointEigenSolver<DenseOf<Scalar>>(
               dense_laplacian<Scalar>(complex, stars, k), dense_star<Scalar>(stars, k),
               Eigen::EigenvaluesOnly)
        .eigenvalues();
}

struct DenseModes {
    Vector values;     ///< ascending
    DenseMatrix forms; ///< a column each, orthonormal in M
};

/// All of A x = lambda M x.
DenseModes dense_modes(const DenseMatrix& A, const DenseMatrix& M);
Vector dense_values(const DenseMatrix& A, const DenseMatrix& M);

// Compiled once, and optimized.
extern template DenseOf<double> dense_laplacian<double>(const CellComplex&, const HodgeStars&, int);
extern template DenseOf<long double> dense_laplacian<long double>(const CellComplex&,
                                                                  const HodgeStars&, int);
extern template Eigen::Matrix<double, Eigen::Dynamic, 1>
dense_eigenvalues<double>(const CellComplex&, const HodgeStars&, int);
extern template Eigen::Matrix<long double, Eigen::Dynamic, 1>
dense_eigenvalues<long double>(const CellComplex&, const HodgeStars&, int);

} // namespace polydec::test
