// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear/grounding.h"
#include "backends/linear/solution_quality.h"
#include "backends/linear_solver.h"

namespace polydec {

/// The common base of all engines: derive from it and write compute() and apply_inverse(). It
/// rejects bad input, removes known kernels, and checks the true residual of every solve, with one
/// step of iterative refinement if that is too large. Powers of two scale matrices and right-hand
/// sides of extreme size, so that squares stay in range in engines.
class CheckedSolver : public LinearSolver {
public:
    std::string name() const final { return name_; }
    EngineTraits traits() const final { return traits_; }
    using LinearSolver::factorize;
    void factorize(std::shared_ptr<const SparseMatrix> A, const MatrixFacts& facts) final;
    std::optional<Index> negative_pivots() const final { return negative_pivots_; }
    const SolveReport& report() const final { return report_; }

protected:
    enum class Pattern { fresh, same };

    struct Solution {
        DenseMatrix columns;
        Index iterations = 0;
    };

    CheckedSolver(std::string name, const EngineTraits& traits, const LinearSolverOptions& options)
        : name_(std::move(name)), traits_(traits), options_(options) {}

    /// Prepares for A: square, finite, compressed, at least 1 x 1, alive until the next call.
    /// facts: for A, so without a kernel unless the engine's treatment is projection. pattern:
    /// same, if the last call succeeded with the same sparsity pattern. Throws SolverFailure, made
    /// by fail(), and std::bad_alloc if memory is insufficient.
    virtual void compute(const SparseMatrix& A, const MatrixFacts& facts, Pattern pattern) = 0;

    /// X with A X = B, for finite B with at least one column. Throws like compute().
    virtual Solution apply_inverse(const DenseMatrix& B) = 0;

    DenseMatrix solve_columns(const Eigen::Ref<const DenseMatrix>& B) final;

    const LinearSolverOptions& options() const { return options_; }

    /// Throws SolverFailure with the engine's name before the reason.
    [[noreturn]] void fail(const std::string& reason) const {
        fail(reason, SolveReport::failed(name_));
    }
    [[noreturn]] void fail(const std::string& reason, SolveReport report) const;

    /// For engines that know the size of a factor, in bytes, before they compute it: throws
    /// OutOfMemory, naming both, if it exceeds memory_limit().
    void check_factor(double bytes, Eigen::Index size) const;

    /// For engines that count negative eigenvalues, in compute(): throws SolverFailure if the facts
    /// exclude them.
    void set_negative_pivots(Index count, const MatrixFacts& facts);

private:
    template <typename Work>
    auto within_memory(const char* purpose, Eigen::Index size, Work work) const;
    void factorize_valid(std::shared_ptr<const SparseMatrix> A, const MatrixFacts& facts,
                         const std::shared_ptr<const SparseMatrix>& previous);
    DenseMatrix solve_valid(const Eigen::Ref<const DenseMatrix>& B);
    void check(const SparseMatrix& A, const MatrixFacts& facts) const;
    void check_right_hand_side(const Eigen::Ref<const DenseMatrix>& B) const;
    std::shared_ptr<const SparseMatrix> treat(const std::shared_ptr<const SparseMatrix>& A,
                                              MatrixFacts& facts);
    Solution invert(const DenseMatrix& B);
    SolutionQuality measure(const DenseMatrix& X, const DenseMatrix& B, const DenseMatrix& R) const;
    bool is_good(const SolutionQuality& quality) const;
    Solution solve_checked(const DenseMatrix& B);
    DenseMatrix solve_scaled(const Eigen::Ref<const DenseMatrix>& B);

    std::string name_;
    EngineTraits traits_;
    LinearSolverOptions options_;

    std::shared_ptr<const SparseMatrix> matrix_;  // as given, or scaled; null until factorized
    std::shared_ptr<const SparseMatrix> treated_; // the engine's matrix: grounded or as given
    int exponent_ = 0;                            // matrix_ is the given one times 2^-exponent_
    std::optional<Kernel> kernel_;
    Inertia inertia_ = Inertia::unneeded;
    double matrix_norm_ = 0.0;
    std::optional<Index> negative_pivots_;
    SolveReport report_;
};

} // namespace polydec
