// SPDX-License-Identifier: MIT
#include "backends/builtin_engines.h"
#include "backends/linear/checked_solver.h"
#include "backends/linear/counting_factor.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <fmt/format.h>

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

} // namespace

std::unique_ptr<LinearSolver> make_eigen_ldlt(const LinearSolverOptions& options) {
    return std::make_unique<EigenLdlt>(options);
}

} // namespace polydec::builtin
