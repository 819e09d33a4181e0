// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear/checked_solver.h"

#include <fmt/format.h>

#include <algorithm>

namespace polydec {

/// The common base of iterative engines. They solve column by column, with right-hand sides scaled
/// to a largest entry of 1, since squares of tiny numbers underflow. A zero right-hand side has the
/// solution zero. The reported iterations are the maximum over the columns.
class IterativeSolver : public CheckedSolver {
protected:
    using CheckedSolver::CheckedSolver;

    /// Solves A x = b, with x zero at first; returns the number of iterations. Throws
    /// SolverFailure, made by fail(), if it does not converge.
    virtual Index iterate(const Vector& b, Eigen::Ref<Vector> x) = 0;

    Solution apply_inverse(const DenseMatrix& B) final {
        Solution solution{DenseMatrix::Zero(B.rows(), B.cols())};
        for (Eigen::Index j = 0; j < B.cols(); ++j) {
            const double scale = B.col(j).lpNorm<Eigen::Infinity>();
            if (scale == 0.0)
                continue;
            auto x = solution.columns.col(j);
            solution.iterations = std::max(solution.iterations, iterate(B.col(j) / scale, x));
            x *= scale;
        }
        return solution;
    }
};

/// The capabilities of conjugate gradients.
constexpr EngineTraits of_conjugate_gradients{.method = Method::iterative,
                                              .symmetry = Symmetry::symmetric,
                                              .definiteness = Definiteness::semidefinite,
                                              .kernel = KernelTreatment::projection};

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

} // namespace polydec
