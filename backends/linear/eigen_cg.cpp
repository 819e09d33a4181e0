// SPDX-License-Identifier: MIT
#include "backends/builtin_engines.h"
#include "backends/linear/checked_solver.h"

#include <Eigen/IterativeLinearSolvers>
#include <fmt/format.h>

#include <algorithm>

namespace polydec::builtin {

namespace {

// Jacobi: Eigen's incomplete Cholesky takes longer to make than it saves.
class EigenCg final : public CheckedSolver {
public:
    explicit EigenCg(const LinearSolverOptions& options)
        : CheckedSolver("eigen.cg",
                        {.method = Method::iterative,
                         .symmetry = Symmetry::symmetric,
                         .definiteness = Definiteness::semidefinite,
                         .kernel = KernelTreatment::projection},
                        options) {}

protected:
    void compute(const SparseMatrix& A, const MatrixFacts& facts, Pattern pattern) override;
    Solution apply_inverse(const DenseMatrix& B) override;

private:
    Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower | Eigen::Upper> cg_;
};

void EigenCg::compute(const SparseMatrix& A, const MatrixFacts&, Pattern) {
    const Vector diagonal = A.diagonal();
    for (Eigen::Index i = 0; i < diagonal.size(); ++i)
        if (diagonal[i] < 0.0)
            fail(fmt::format("the matrix is not positive semidefinite, as its facts say: entry "
                             "({0}, {0}) is {1:.3g}",
                             i, diagonal[i]));
    cg_.setTolerance(options().tolerance);
    cg_.setMaxIterations(iteration_limit(A.rows()));
    cg_.compute(A);
}

CheckedSolver::Solution EigenCg::apply_inverse(const DenseMatrix& B) {
    Solution solution{DenseMatrix::Zero(B.rows(), B.cols())};
    for (Eigen::Index j = 0; j < B.cols(); ++j) {
        // Squares of tiny numbers vanish, so the iteration sees a right-hand side of size one.
        const double scale = B.col(j).lpNorm<Eigen::Infinity>();
        if (scale == 0.0)
            continue;
        const Vector x = cg_.solve(B.col(j) / scale);
        const auto iterations = static_cast<Index>(cg_.iterations());
        if (cg_.info() != Eigen::Success || !x.allFinite())
            fail(fmt::format("no convergence after {} iterations, residual {:.2g}: the matrix is "
                             "badly conditioned, indefinite, or the right-hand side is none of "
                             "its images\nTake a direct engine.",
                             iterations, cg_.error()));
        solution.columns.col(j) = scale * x;
        solution.iterations = std::max(solution.iterations, iterations);
    }
    return solution;
}

} // namespace

std::unique_ptr<LinearSolver> make_eigen_cg(const LinearSolverOptions& options) {
    return std::make_unique<EigenCg>(options);
}

} // namespace polydec::builtin
