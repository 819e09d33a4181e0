// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear_solver.h"

#include <memory>
#include <string>
#include <vector>

namespace polydec {

/// The names of the engines that suit a matrix, best first; those not in this program are left out.
/// Symmetric and definite, or semidefinite with known kernel: cholmod, eigen.ldlt, eigen.lu,
/// eigen.cg; above a size where factors outgrow memory, in three and more dimensions, eigen.cg
/// first and no LU. Semidefinite without known kernel: eigen.cg, which needs none, then the others.
/// Indefinite: L D L^T, then LU. General: eigen.lu, eigen.bicgstab. With inertia wanted: those
/// alone that count.
std::vector<std::string> suitable_engines(const SparseMatrix& A, const MatrixFacts& facts);

/// The engine `auto`: takes the first of suitable_engines() whose factorization and whose solves
/// are good, and goes on to the next where one fails; report().tried tells the story.
/// Throws SolverFailure with all of it if none is left, OutOfMemory if one of them needed more
/// memory; bad input is refused as by every engine.
class AutoSolver final : public LinearSolver {
public:
    explicit AutoSolver(const LinearSolverOptions& options = {}) : options_(options) {}

    std::string name() const override { return "auto"; }
    EngineTraits traits() const override { return {.inertia = Inertia::wanted}; }
    using LinearSolver::factorize;
    void factorize(std::shared_ptr<const SparseMatrix> A, const MatrixFacts& facts) override;
    std::optional<Index> negative_pivots() const override;
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
    std::size_t next_ = 0;                 // the candidate to be tried when the engine fails
    std::unique_ptr<LinearSolver> engine_; // null: nothing is factorized
    std::vector<std::string> failures_;
    bool lacks_memory_ = false; // whether that is one of the failures
    SolveReport report_;
};

} // namespace polydec
