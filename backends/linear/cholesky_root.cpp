// SPDX-License-Identifier: MIT
#include "backends/linear/cholesky_root.h"

#include "backends/linear/counting_factor.h"
#include "base/errors.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <fmt/format.h>

namespace polydec {

using ColumnMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, Index>;

struct CholeskyRoot::Factor
    : CountingFactor<Eigen::SimplicialLLT<ColumnMatrix, Eigen::Lower, Eigen::AMDOrdering<Index>>> {
};

CholeskyRoot::CholeskyRoot(const SparseMatrix& M) {
    auto factor = std::make_unique<Factor>();
    const ColumnMatrix columns = M;
    factor->analyzePattern(columns);
    if (!factor->fits())
        throw SolverFailure(fmt::format("the root of a {} x {} matrix has more than 2^31 - 1 "
                                        "entries: use a diagonal star, or a smaller mesh",
                                        M.rows(), M.cols()));
    factor->factorize(columns);
    if (factor->info() != Eigen::Success)
        throw InvalidInput("a matrix of inner products is not positive definite");
    factor_ = std::move(factor);
}

CholeskyRoot::~CholeskyRoot() = default;

DenseMatrix CholeskyRoot::times(const DenseMatrix& X) const {
    return factor_->matrixU() * DenseMatrix(factor_->permutationP() * X);
}

DenseMatrix CholeskyRoot::inverse_times(const DenseMatrix& X) const {
    return factor_->permutationPinv() * DenseMatrix(factor_->matrixU().solve(X));
}

DenseMatrix CholeskyRoot::transposed_times(const DenseMatrix& X) const {
    return factor_->permutationPinv() * DenseMatrix(factor_->matrixL() * X);
}

DenseMatrix CholeskyRoot::inverse_transposed_times(const DenseMatrix& X) const {
    return factor_->matrixL().solve(DenseMatrix(factor_->permutationP() * X));
}

Vector CholeskyRoot::solve(const Vector& b) const {
    return factor_->solve(b);
}

} // namespace polydec
