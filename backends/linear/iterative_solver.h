// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear/checked_solver.h"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace polydec {

/// What iterative engines have in common: they solve column by column, and see right-hand sides
/// whose largest entry is 1 alone, since squares of tiny numbers vanish. The solution for zero is
/// zero; the iterations of a solution are the most that a column took.
class IterativeSolver : public CheckedSolver {
protected:
    using CheckedSolver::CheckedSolver;

    /// Writes x with A x = b to x, which is zero before, and tells the iterations that it took.
    /// Throws SolverFailure, made by fail(), where they lead nowhere.
    virtual Index iterate(const Vector& b, Eigen::Ref<Vector> x) = 0;

    Solution apply_inverse(const DenseMatrix& B) final;
};

/// What conjugate gradients can do.
constexpr EngineTraits of_conjugate_gradients{.method = Method::iterative,
                                              .symmetry = Symmetry::symmetric,
                                              .definiteness = Definiteness::semidefinite,
                                              .kernel = KernelTreatment::projection};

/// An engine by one of Eigen's iterations; advice: what to do where it does not converge.
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
