// SPDX-License-Identifier: MIT
#include "backends/builtin_engines.h"
#include "backends/linear/iterative_solver.h"

#include <Eigen/IterativeLinearSolvers>
#include <fmt/format.h>

#include <limits>

namespace polydec::builtin {

namespace {

/// An engine from one of Eigen's iterations; advice: shown if it does not converge.
template <class Iteration>
class EigenIteration : public IterativeSolver {
protected:
    EigenIteration(const char* name, const EngineTraits& traits, const LinearSolverOptions& options,
                   const char* advice)
        : IterativeSolver(name, traits, options), advice_(advice) {}

    void compute(const SparseMatrix& A, const MatrixFacts&, Pattern) override {
        iteration_.setTolerance(options().tolerance);
        iteration_.setMaxIterations(iteration_limit(options(), A.rows()));
        iteration_.compute(A);
    }

    Index iterate(const Vector& b, Eigen::Ref<Vector> x) final {
        x = iteration_.solve(b);
        const auto iterations = static_cast<Index>(iteration_.iterations());
        if (iteration_.info() != Eigen::Success || !x.allFinite())
            fail(fmt::format("no convergence after {} iterations, residual {:.2g}: {}", iterations,
                             iteration_.error(), advice_),
                 SolveReport::failed(name(), iterations, iteration_.error()));
        return iterations;
    }

    Iteration iteration_;

private:
    const char* advice_;
};

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

std::unique_ptr<LinearSolver> make_eigen_cg(const LinearSolverOptions& options) {
    return std::make_unique<EigenCg>(options);
}

std::unique_ptr<LinearSolver> make_eigen_bicgstab(const LinearSolverOptions& options) {
    return std::make_unique<EigenBicgstab>(options);
}

} // namespace polydec::builtin
