// SPDX-License-Identifier: MIT
#include "backends/builtin_engines.h"
#include "backends/linear/iterative_solver.h"

#include <Eigen/IterativeLinearSolvers>

#include <limits>

namespace polydec::builtin {

namespace {

// ILUT, since BiCGSTAB with a diagonal preconditioner stagnates where convection dominates, on
// indefinite matrices, and on zeros in the diagonal. It costs about ten times the matrix' memory.
constexpr double drop_tolerance = 1e-5;
constexpr int fill_factor = 10;

using Bicgstab = Eigen::BiCGSTAB<SparseMatrix, Eigen::IncompleteLUT<double, Index>>;

class EigenBicgstab final : public EigenIteration<Bicgstab> {
public:
    explicit EigenBicgstab(const LinearSolverOptions& options)
        : EigenIteration("eigen.bicgstab", {.method = Method::iterative}, options,
                         "the matrix is badly conditioned or singular\nUse eigen.lu.") {
        iteration_.preconditioner().setDroptol(drop_tolerance);
        iteration_.preconditioner().setFillfactor(fill_factor);
    }

protected:
    void compute(const SparseMatrix& A, const MatrixFacts& facts, Pattern pattern) override {
        if (A.nonZeros() > std::numeric_limits<Index>::max() / (fill_factor + 2))
            fail("the preconditioner of this matrix has more than 2^31 - 1 entries");
        EigenIteration::compute(A, facts, pattern);
        if (iteration_.info() != Eigen::Success)
            fail("the incomplete factorization broke down: a row of the matrix is zero");
    }
};

} // namespace

std::unique_ptr<LinearSolver> make_eigen_bicgstab(const LinearSolverOptions& options) {
    return std::make_unique<EigenBicgstab>(options);
}

} // namespace polydec::builtin
