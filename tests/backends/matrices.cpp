// SPDX-License-Identifier: MIT
#include "tests/backends/matrices.h"

namespace polydec::test {

namespace {

/// Engines registered at the first call, before tests register their own.
std::vector<std::string> engine_names(EngineKind kind) {
    static const auto at_first = engines();
    std::vector<std::string> names;
    for (const auto& engine : at_first)
        if (engine.kind == kind && engine.available)
            names.push_back(engine.name);
    return names;
}

} // namespace

std::vector<std::string> linear_engine_names() {
    return engine_names(EngineKind::linear);
}

std::vector<std::string> eigen_engine_names() {
    return engine_names(EngineKind::eigen);
}

std::vector<std::string> integrator_engine_names() {
    return engine_names(EngineKind::integrator);
}

std::string test_name(std::string engine) {
    std::replace_if(
        engine.begin(), engine.end(), [](char letter) { return letter == '.' || letter == '-'; },
        '_');
    return engine;
}

SparseMatrix grid_laplacian(Index m, int dimension) {
    Index size = 1;
    for (int axis = 0; axis < dimension; ++axis)
        size *= m;

    std::vector<Eigen::Triplet<double>> entries;
    for (Index i = 0; i < size; ++i) {
        entries.emplace_back(i, i, 2.0 * dimension);
        Index stride = 1;
        for (int axis = 0; axis < dimension; ++axis, stride *= m) {
            if ((i / stride) % m + 1 == m)
                continue;
            entries.emplace_back(i, i + stride, -1.0);
            entries.emplace_back(i + stride, i, -1.0);
        }
    }
    SparseMatrix A(size, size);
    A.setFromTriplets(entries.begin(), entries.end());
    return A;
}

SparseMatrix neumann_laplacian(Index m) {
    SparseMatrix A = grid_laplacian(m);
    const Vector row_sums = A * Vector::Ones(A.cols());
    for (Index i = 0; i < A.rows(); ++i)
        A.coeffRef(i, i) -= row_sums[i];
    return A;
}

SparseMatrix convection_diffusion(Index m, double peclet) {
    SparseMatrix A = grid_laplacian(m);
    for (Index i = 0; i < A.rows(); ++i)
        for (SparseMatrix::InnerIterator entry(A, i); entry; ++entry) {
            if (entry.col() == i + 1)
                entry.valueRef() += peclet;
            if (entry.col() == i - 1)
                entry.valueRef() -= peclet;
        }
    return A;
}

SparseMatrix shifted(const SparseMatrix& A, double shift) {
    return A - shift * identity(static_cast<Index>(A.rows()));
}

DenseMatrix random_matrix(Index rows, Index columns, unsigned seed) {
    return random_vector(rows * columns, seed).reshaped(rows, columns);
}

DenseMatrix random_symmetric(Index size, unsigned seed) {
    const DenseMatrix A = random_matrix(size, size, seed);
    return A + A.transpose();
}

MatrixFacts positive() {
    return {.symmetry = Symmetry::symmetric, .definiteness = Definiteness::positive};
}

MatrixFacts semidefinite(const DenseMatrix& kernel) {
    MatrixFacts facts{.symmetry = Symmetry::symmetric, .definiteness = Definiteness::semidefinite};
    facts.kernel = kernel;
    return facts;
}

MatrixFacts indefinite() {
    return {.symmetry = Symmetry::symmetric, .definiteness = Definiteness::indefinite};
}

MatrixFacts counted() {
    MatrixFacts facts = indefinite();
    facts.inertia = Inertia::wanted;
    return facts;
}

MatrixFacts general() {
    return {};
}

bool solves(const SparseMatrix& A, const DenseMatrix& X, const DenseMatrix& B) {
    if (X.rows() != A.cols() || X.cols() != B.cols() || !X.allFinite())
        return false;
    const DenseMatrix R = B - A * X;
    for (Eigen::Index j = 0; j < B.cols(); ++j)
        if (R.col(j).stableNorm() > 1e-9 * B.col(j).stableNorm())
            return false;
    return true;
}

Vector dense_eigenvalues(const SparseMatrix& A) {
    return Eigen::SelfAdjointEigenSolver<DenseMatrix>(DenseMatrix(A), Eigen::EigenvaluesOnly)
        .eigenvalues();
}

Index negative_eigenvalues(const SparseMatrix& A) {
    return number_below(dense_eigenvalues(A), 0);
}

std::vector<double> grid_eigenvalues(Index m, int dimension) {
    std::vector<double> sums{0.0};
    for (int axis = 0; axis < dimension; ++axis) {
        std::vector<double> longer;
        for (const double sum : sums)
            for (Index i = 1; i <= m; ++i)
                longer.push_back(sum + 2.0 - 2.0 * std::cos(i * std::numbers::pi / (m + 1)));
        sums = longer;
    }
    std::sort(sums.begin(), sums.end());
    return sums;
}

double orthonormality_defect(const DenseMatrix& columns) {
    const DenseMatrix gram = columns.transpose() * columns;
    return (gram - DenseMatrix::Identity(gram.rows(), gram.cols())).cwiseAbs().maxCoeff();
}

} // namespace polydec::test
