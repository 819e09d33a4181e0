// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear_solver.h"

#include <memory>
#include <string>
#include <vector>

namespace polydec {

/// The engines that suit a matrix, best first, among those in this program. Symmetric and definite,
/// or semidefinite with known kernel: cholmod, eigen.ldlt, eigen.lu, eigen.cg; in three and more
/// dimensions, above a size where factors exceed memory, eigen.cg first and no LU. Semidefinite
/// without known kernel: eigen.cg, which needs none, then the others. Indefinite: L D L^T, then LU.
/// General: eigen.lu, eigen.bicgstab. If inertia is wanted: only engines that count.
std::vector<std::string> suitable_engines(const SparseMatrix& A, const MatrixFacts& facts);

/// A warning that names better engines for this matrix that are not installed, if the difference
/// takes seconds, and says how to get CHOLMOD, or the best of them; else empty.
std::string missed_engines(const SparseMatrix& A, const MatrixFacts& facts);

/// The warning of missed_engines() for the first matrix of the program for which `auto` missed an
/// engine. Returned once; empty before and afterwards.
std::string take_missed_engines();

/// The engine `auto`: uses the first of suitable_engines() with a good factorization and good
/// solves, and switches to the next after a failure; report().tried lists the attempts. Throws
/// SolverFailure with all failures if none is left, OutOfMemory if one of them needed more memory;
/// bad input throws as in every engine.
class AutoSolver final : public LinearSolver {
public:
    explicit AutoSolver(const LinearSolverOptions& options = {}) : options_(options) {}

    std::string name() const override { return "auto"; }
    EngineTraits traits() const override { return {.inertia = Inertia::wanted}; }
    using LinearSolver::factorize;
    void factorize(std::shared_ptr<const SparseMatrix> A, const MatrixFacts& facts) override;
    std::optional<Index> negative_pivots() const override {
        return engine_ ? engine_->negative_pivots() : std::nullopt;
    }
    const SolveReport& report() const override { return report_; }

protected:
    DenseMatrix solve_columns(const Eigen::Ref<const DenseMatrix>& B) override;

private:
    void start();
    void advance();
    template <typename Work>
    bool succeeds(Work work);
    [[noreturn]] void fail() const;

    LinearSolverOptions options_;
    std::shared_ptr<const SparseMatrix> matrix_;
    MatrixFacts facts_;
    std::vector<std::string> candidates_;
    std::size_t next_ = 0;                 // the candidate to try when the engine fails
    std::unique_ptr<LinearSolver> engine_; // null: not factorized
    std::vector<std::string> failures_;
    bool lacks_memory_ = false; // whether one of the failures is lack of memory
    SolveReport report_;
};

} // namespace polydec
