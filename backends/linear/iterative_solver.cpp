// SPDX-License-Identifier: MIT
#include "backends/linear/iterative_solver.h"

#include <algorithm>

namespace polydec {

CheckedSolver::Solution IterativeSolver::apply_inverse(const DenseMatrix& B) {
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

} // namespace polydec
