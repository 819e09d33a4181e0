// SPDX-License-Identifier: MIT
#include "backends/builtin_engines.h"
#include "backends/linear/checked_solver.h"

#include <Eigen/IterativeLinearSolvers>
#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace polydec::builtin {

namespace {

// ILUT, since BiCGSTAB with a diagonal preconditioner stagnates where convection dominates, on
// indefinite matrices, and on zeros in the diagonal. It costs about ten times the matrix' memory.
constexpr double drop_tolerance = 1e-5;
constexpr int fill_factor = 10;

class EigenBicgstab final : public CheckedSolver {
public:
    explicit EigenBicgstab(const LinearSolverOptions& options)
        : CheckedSolver("eigen.bicgstab", {.method = Method::iterative}, options) {}

protected:
    void compute(const SparseMatrix& A, const MatrixFacts& facts, Pattern pattern) override;
    Solution apply_inverse(const DenseMatrix& B) override;

private:
    Eigen::BiCGSTAB<SparseMatrix, Eigen::IncompleteLUT<double, Index>> bicgstab_;
};

void EigenBicgstab::compute(const SparseMatrix& A, const MatrixFacts&, Pattern) {
    if (A.nonZeros() > std::numeric_limits<Index>::max() / (fill_factor + 2))
        fail("the preconditioner of this matrix has more than 2^31 - 1 entries");
    bicgstab_.preconditioner().setDroptol(drop_tolerance);
    bicgstab_.preconditioner().setFillfactor(fill_factor);
    bicgstab_.setTolerance(options().tolerance);
    bicgstab_.setMaxIterations(iteration_limit(A.rows()));
    bicgstab_.compute(A);
    if (bicgstab_.info() != Eigen::Success)
        fail("the incomplete factorization broke down: a row of the matrix is zero");
}

CheckedSolver::Solution EigenBicgstab::apply_inverse(const DenseMatrix& B) {
    Solution solution{DenseMatrix::Zero(B.rows(), B.cols())};
    for (Eigen::Index j = 0; j < B.cols(); ++j) {
        // Squares of tiny numbers vanish, so the iteration sees a right-hand side of size one.
        const double scale = B.col(j).lpNorm<Eigen::Infinity>();
        if (scale == 0.0)
            continue;
        const Vector x = bicgstab_.solve(B.col(j) / scale);
        const auto iterations = static_cast<Index>(bicgstab_.iterations());
        if (bicgstab_.info() != Eigen::Success || !x.allFinite())
            fail(fmt::format("no convergence after {} iterations, residual {:.2g}: the matrix is "
                             "badly conditioned or singular\nTake eigen.lu.",
                             iterations, bicgstab_.error()));
        solution.columns.col(j) = scale * x;
        solution.iterations = std::max(solution.iterations, iterations);
    }
    return solution;
}

} // namespace

std::unique_ptr<LinearSolver> make_eigen_bicgstab(const LinearSolverOptions& options) {
    return std::make_unique<EigenBicgstab>(options);
}

} // namespace polydec::builtin
