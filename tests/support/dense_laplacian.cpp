// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test {
namespace {

DenseMatrix dense_star(const HodgeStars& stars, int k) {
    return DenseMatrix(stars[k].matrix());
}

/// star_k Delta_k with every star a dense matrix.
Extended dense_laplacian(const CellComplex& complex, const HodgeStars& stars, int k) {
    using Incidence = Eigen::SparseMatrix<long double>;
    const auto star = [&](int j) { return Extended(dense_star(stars, j).cast<long double>()); };
    Extended A = Extended::Zero(complex.size(k), complex.size(k));
    if (k < complex.dimension()) {
        const Incidence d = derivative(complex, k).cast<long double>();
        A += d.transpose() * Extended(star(k + 1) * d);
    }
    if (k > 0) {
        const Incidence d = derivative(complex, k - 1).cast<long double>();
        const Extended B = star(k) * d;
        A += B * solve_extended(star(k - 1), B.transpose()).X; // also where it is not positive
    }
    return A;
}

} // namespace

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

Vector dense_spectrum(const Discretization& mesh, int k) {
    return dense_values(DenseMatrix(symmetric_laplacian(mesh, k).matrix()),
                        star(mesh.volumes(), k).diagonal().asDiagonal());
}

Index number_below(const Vector& values, double shift) {
    return static_cast<Index>((values.array() < shift).count());
}

ExtendedVector extended_eigenvalues(const CellComplex& complex, const HodgeStars& stars, int k) {
    return extended_eigenvalues(dense_laplacian(complex, stars, k),
                                dense_star(stars, k).cast<long double>());
}

} // namespace polydec::test
