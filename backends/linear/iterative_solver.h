// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear/checked_solver.h"

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

} // namespace polydec
