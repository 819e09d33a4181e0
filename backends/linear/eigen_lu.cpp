// SPDX-License-Identifier: MIT
#include "backends/builtin_engines.h"
#include "backends/linear/checked_solver.h"

#include <Eigen/SparseLU>
#include <fmt/format.h>

#include <vector>

namespace polydec::builtin {

namespace {

using ColumnMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, Index>;

class EigenLu final : public CheckedSolver {
public:
    explicit EigenLu(const LinearSolverOptions& options) : CheckedSolver("eigen.lu", {}, options) {}

protected:
    void compute(const SparseMatrix& A, const MatrixFacts&, Pattern pattern) override {
        refuse_empty_lines(A);
        const ColumnMatrix columns = A;
        if (pattern == Pattern::fresh)
            lu_.analyzePattern(columns);
        lu_.factorize(columns);
        if (lu_.info() != Eigen::Success)
            fail("the matrix is singular: " + lu_.lastErrorMessage());
    }

    Solution apply_inverse(const DenseMatrix& B) override { return {lu_.solve(B)}; }

private:
    // SparseLU takes for granted that there is something in every row and column.
    void refuse_empty_lines(const SparseMatrix& A) const {
        std::vector<bool> column_is_used(static_cast<std::size_t>(A.cols()), false);
        for (Eigen::Index i = 0; i < A.rows(); ++i) {
            bool row_is_used = false;
            for (SparseMatrix::InnerIterator entry(A, i); entry; ++entry) {
                if (entry.value() == 0.0)
                    continue;
                row_is_used = true;
                column_is_used[static_cast<std::size_t>(entry.col())] = true;
            }
            if (!row_is_used)
                fail(fmt::format("the matrix is singular: row {} is zero", i));
        }
        for (std::size_t j = 0; j < column_is_used.size(); ++j)
            if (!column_is_used[j])
                fail(fmt::format("the matrix is singular: column {} is zero", j));
    }

    Eigen::SparseLU<ColumnMatrix, Eigen::COLAMDOrdering<Index>> lu_;
};

} // namespace

std::unique_ptr<LinearSolver> make_eigen_lu(const LinearSolverOptions& options) {
    return std::make_unique<EigenLu>(options);
}

} // namespace polydec::builtin
