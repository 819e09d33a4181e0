// SPDX-License-Identifier: MIT
#include "backends/builtin_engines.h"
#include "backends/linear/iterative_solver.h"

#include <Eigen/IterativeLinearSolvers>
#include <fmt/format.h>

namespace polydec::builtin {

namespace {

// Jacobi: Eigen's incomplete Cholesky takes longer to make than it saves.
using ConjugateGradients = Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower | Eigen::Upper>;

class EigenCg final : public EigenIteration<ConjugateGradients> {
public:
    explicit EigenCg(const LinearSolverOptions& options)
        : EigenIteration("eigen.cg", of_conjugate_gradients, options,
                         "the matrix is badly conditioned or indefinite, or the right-hand side is "
                         "not in its range\n"
                         "Use a direct engine.") {}

protected:
    void compute(const SparseMatrix& A, const MatrixFacts& facts, Pattern pattern) override {
        const Vector diagonal = A.diagonal();
        for (Eigen::Index i = 0; i < diagonal.size(); ++i)
            if (diagonal[i] < 0.0)
                fail(fmt::format("the matrix is not positive semidefinite, although its facts say "
                                 "so: entry ({0}, {0}) is {1:.3g}",
                                 i, diagonal[i]));
        EigenIteration::compute(A, facts, pattern);
    }
};

} // namespace

std::unique_ptr<LinearSolver> make_eigen_cg(const LinearSolverOptions& options) {
    return std::make_unique<EigenCg>(options);
}

} // namespace polydec::builtin
