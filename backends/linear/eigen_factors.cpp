// SPDX-License-Identifier: MIT
#include "backends/builtin_engines.h"
#include "backends/linear/checked_solver.h"
#include "backends/linear/counting_factor.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#include <fmt/format.h>

#include <vector>

namespace polydec::builtin {

namespace {

using ColumnMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, Index>;

using Ldlt =
    CountingFactor<Eigen::SimplicialLDLT<ColumnMatrix, Eigen::Lower, Eigen::AMDOrdering<Index>>>;

class EigenLdlt final : public CheckedSolver {
public:
    explicit EigenLdlt(const LinearSolverOptions& options)
        : CheckedSolver("eigen.ldlt", {.symmetry = Symmetry::symmetric, .inertia = Inertia::wanted},
                        options) {}

protected:
    void compute(const SparseMatrix& A, const MatrixFacts& facts, Pattern pattern) override {
        // The rows of a symmetric matrix are its columns.
        const ColumnMatrix columns = Eigen::Map<const ColumnMatrix>(
            A.rows(), A.cols(), A.nonZeros(), A.outerIndexPtr(), A.innerIndexPtr(), A.valuePtr());
        if (pattern == Pattern::fresh)
            ldlt_.analyzePattern(columns);
        if (!ldlt_.fits())
            fail(fmt::format("the factor of this {} x {} matrix has more than 2^31 - 1 entries\n"
                             "Use cholmod or eigen.cg.",
                             A.rows(), A.cols()));
        check_factor((sizeof(double) + sizeof(Index)) * double(ldlt_.entries()), A.rows());
        ldlt_.factorize(columns);
        if (ldlt_.info() != Eigen::Success || !ldlt_.vectorD().allFinite())
            fail("zero pivot: the matrix, or a leading block of it, is singular\n"
                 "Move the shift, give the kernel in the facts, or use eigen.lu.");

        set_negative_pivots(static_cast<Index>((ldlt_.vectorD().array() < 0.0).count()), facts);
    }

    Solution apply_inverse(const DenseMatrix& B) override { return {ldlt_.solve(B)}; }

private:
    Ldlt ldlt_;
};

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

std::unique_ptr<LinearSolver> make_eigen_ldlt(const LinearSolverOptions& options) {
    return std::make_unique<EigenLdlt>(options);
}

std::unique_ptr<LinearSolver> make_eigen_lu(const LinearSolverOptions& options) {
    return std::make_unique<EigenLu>(options);
}

} // namespace polydec::builtin
