// SPDX-License-Identifier: MIT
#pragma once

#include "tests/support/test.h"

/// What the tests of the backends share: matrices, facts, and the check that a solution is one.
namespace polydec::test {

/// Names of all linear engines that this program has; registers the optional ones first.
std::vector<std::string> linear_engine_names();

/// The same for eigensolvers.
std::vector<std::string> eigen_engine_names();
std::vector<std::string> integrator_engine_names();

/// An engine's name as a name that a test may have.
std::string test_name(std::string engine);

/// Laplacian of a grid of m x m (or m x m x m) inner points with spacing 1, value 0 outside.
SparseMatrix grid_laplacian(Index m, int dimension = 2);

/// Laplacian of the graph of an m x m grid: its kernel is the constants.
SparseMatrix neumann_laplacian(Index m);

/// Laplacian of an m x m grid with a wind along x of the given cell Peclet number.
SparseMatrix convection_diffusion(Index m, double peclet);

SparseMatrix shifted(const SparseMatrix& A, double shift);
DenseMatrix random_matrix(Index rows, Index columns, unsigned seed);
DenseMatrix random_symmetric(Index size, unsigned seed);

MatrixFacts positive();
MatrixFacts semidefinite(const DenseMatrix& kernel = {});
MatrixFacts indefinite();
MatrixFacts general();

/// Indefinite, with negative pivots counted.
MatrixFacts counted();

/// Whether X solves A X = B: finite, |b - A x| <= 1e-9 |b| for each column.
bool solves(const SparseMatrix& A, const DenseMatrix& X, const DenseMatrix& B);

/// As little as an engine can be: no info(), no matrix type.
struct DenseLu {
    void compute(const SparseMatrix& A) { lu.compute(DenseMatrix(A)); }
    DenseMatrix solve(const DenseMatrix& B) const { return lu.solve(B); }
    Eigen::PartialPivLU<DenseMatrix> lu;
};

/// By a dense eigensolver, ascending, and how many of them are negative.
Vector dense_eigenvalues(const SparseMatrix& A);
Index negative_eigenvalues(const SparseMatrix& A);

/// Eigenvalues of grid_laplacian: sums of 2 - 2 cos(i pi / (m + 1)), ascending.
std::vector<double> grid_eigenvalues(Index m, int dimension);

/// How far columns are from orthonormal.
double orthonormality_defect(const DenseMatrix& columns);

} // namespace polydec::test
