// SPDX-License-Identifier: MIT
#include "backends/linear/checked_solver.h"

#include "base/row_sum_norm.h"
#include "system/memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <new>
#include <utility>
#include <vector>

namespace polydec {

namespace {

constexpr double kernel_limit = 1e-8;

bool same_pattern(const SparseMatrix& A, const SparseMatrix& B) {
    return A.rows() == B.rows() && A.nonZeros() == B.nonZeros() &&
           std::equal(A.outerIndexPtr(), A.outerIndexPtr() + A.rows() + 1, B.outerIndexPtr()) &&
           std::equal(A.innerIndexPtr(), A.innerIndexPtr() + A.nonZeros(), B.innerIndexPtr());
}

void check_entries(const SparseMatrix& A, const std::string& name) {
    for (Eigen::Index i = 0; i < A.rows(); ++i)
        for (SparseMatrix::InnerIterator entry(A, i); entry; ++entry)
            if (!std::isfinite(entry.value()))
                throw InvalidInput(
                    fmt::format("{}: entry ({}, {}) of the matrix is {}: expected a finite number",
                                name, i, entry.col(), entry.value()));
}

double ratio(double numerator, double denominator) {
    return numerator == 0.0 ? 0.0 : numerator / denominator;
}

// The 2-norm of a vector whose largest entry is known: squares that neither overflow nor vanish are
// summed in a third of the time.
template <typename Column>
double length(const Column& x, double largest) {
    constexpr double safe = 1e100;
    return largest < safe && largest > 1.0 / safe ? x.norm() : x.stableNorm();
}

// Squares and a few products of numbers within 2^-200 .. 2^200 are ordinary ones; beyond, the power
// of two that brings the largest of them near 1.
int exponent_to_remove(double largest) {
    constexpr int harmless = 200;
    if (!(largest > 0.0) || !std::isfinite(largest))
        return 0;
    const int exponent = std::ilogb(largest);
    return std::abs(exponent) <= harmless ? 0 : exponent;
}

template <typename Numbers>
void scale(Numbers&& numbers, int exponent) {
    for (double& number : numbers)
        number = std::ldexp(number, exponent);
}

// A residual that is not a number is larger than any.
double worse(double a, double b) {
    return b <= a ? a : b;
}

} // namespace

void CheckedSolver::fail(const std::string& reason, SolveReport report) const {
    throw SolverFailure(fmt::format("{}: {}", name_, reason), std::move(report));
}

void CheckedSolver::check_factor(double bytes, Eigen::Index size) const {
    const auto lack =
        lack_of_memory(bytes, fmt::format("{0}: the factor of a {1} x {1} matrix", name_, size));
    if (!lack.empty())
        throw OutOfMemory(lack +
                              "\nUse an iterative engine, or raise the limit (set_memory_limit).",
                          SolveReport::failed(name_));
}

void CheckedSolver::set_negative_pivots(Index count, const MatrixFacts& facts) {
    if (facts.definiteness == Definiteness::positive && count > 0)
        fail(fmt::format("the matrix is not positive definite, although its facts say so: {} "
                         "pivots are negative",
                         count));
    negative_pivots_ = count;
}

template <typename Work>
auto CheckedSolver::within_memory(const char* purpose, Eigen::Index size, Work work) const {
    try {
        return work();
    } catch (const std::bad_alloc&) {
        throw OutOfMemory(fmt::format("{0}: not enough memory to {1} a {2} x {2} matrix\n{3}",
                                      name_, purpose, size,
                                      traits_.method == Method::direct
                                          ? "Use an iterative engine, or allow more memory."
                                          : "Allow more memory."),
                          SolveReport::failed(name_));
    }
}

void CheckedSolver::check(const SparseMatrix& A, const MatrixFacts& facts) const {
    if (A.rows() != A.cols())
        throw InvalidInput(
            fmt::format("{}: a {} x {} matrix is not square", name_, A.rows(), A.cols()));
    if (facts.symmetry == Symmetry::general) {
        if (traits_.symmetry == Symmetry::symmetric)
            throw InvalidInput(name_ + ": supports only symmetric matrices, and the facts do not "
                                       "say that this matrix is symmetric\n"
                                       "Say so in the facts, or use eigen.lu.");
        if (facts.inertia == Inertia::wanted || facts.kernel.cols() > 0)
            throw InvalidInput(name_ + ": inertia and kernels need a symmetric matrix, and the "
                                       "facts do not say that this matrix is symmetric");
    } else if (facts.definiteness > traits_.definiteness) {
        throw InvalidInput(name_ + ": supports only positive (semi)definite matrices, and the "
                                   "facts do not say that this matrix is one\n"
                                   "Use eigen.ldlt or eigen.lu.");
    }
    if (facts.inertia == Inertia::wanted && traits_.inertia == Inertia::unneeded)
        throw InvalidInput(name_ + ": does not count negative eigenvalues\n"
                                   "Use eigen.ldlt or cholmod.");
    check_entries(A, name_);
}

std::shared_ptr<const SparseMatrix>
CheckedSolver::treat(const std::shared_ptr<const SparseMatrix>& A, MatrixFacts& facts) {
    kernel_.reset();
    if (facts.kernel.cols() == 0)
        return A;
    kernel_.emplace(*A, facts.kernel);
    if (traits_.kernel == KernelTreatment::projection)
        return A;

    facts.kernel.resize(0, 0);
    // Without its whole kernel, semidefinite is definite.
    if (facts.definiteness == Definiteness::semidefinite)
        facts.definiteness = Definiteness::positive;
    return std::make_shared<const SparseMatrix>(kernel_->grounded(*A));
}

void CheckedSolver::factorize(std::shared_ptr<const SparseMatrix> A, const MatrixFacts& facts) {
    const auto previous = std::exchange(treated_, nullptr);
    matrix_ = nullptr;
    report_ = {};
    if (!A)
        throw InvalidInput(name_ + ": the pointer to the matrix is null");
    check(*A, facts);
    const auto size = A->rows();
    within_memory("factorize", size, [&] { factorize_valid(std::move(A), facts, previous); });
}

void CheckedSolver::factorize_valid(std::shared_ptr<const SparseMatrix> A, const MatrixFacts& facts,
                                    const std::shared_ptr<const SparseMatrix>& previous) {
    if (!A->isCompressed()) {
        auto compressed = std::make_shared<SparseMatrix>(*A);
        compressed->makeCompressed();
        A = std::move(compressed);
    }
    exponent_ = exponent_to_remove(largest_entry(*A));
    if (exponent_ != 0) {
        auto scaled = std::make_shared<SparseMatrix>(*A);
        scale(scaled->coeffs(), -exponent_);
        A = std::move(scaled);
    }

    MatrixFacts treated_facts = facts;
    auto treated = treat(A, treated_facts);
    const bool is_known = previous && same_pattern(*previous, *treated);
    if (treated->rows() > 0) {
        negative_pivots_.reset();
        compute(*treated, treated_facts, is_known ? Pattern::same : Pattern::fresh);
    }

    inertia_ = facts.inertia;
    matrix_norm_ = row_sum_norm(*A);
    treated_ = std::move(treated);
    matrix_ = std::move(A);
}

void CheckedSolver::check_right_hand_side(const Eigen::Ref<const DenseMatrix>& B) const {
    if (!matrix_)
        throw InvalidInput(name_ + ": call factorize() successfully before solve()");
    if (B.rows() != matrix_->rows())
        throw InvalidInput(fmt::format("{}: a right-hand side of {} rows for a {} x {} matrix",
                                       name_, B.rows(), matrix_->rows(), matrix_->cols()));
    if (B.allFinite())
        return;
    for (Eigen::Index j = 0; j < B.cols(); ++j)
        for (Eigen::Index i = 0; i < B.rows(); ++i)
            if (!std::isfinite(B(i, j)))
                throw InvalidInput(fmt::format(
                    "{}: entry {} of right-hand side {} is {}: expected a finite number", name_, i,
                    j, B(i, j)));
}

CheckedSolver::Solution CheckedSolver::invert(const DenseMatrix& B) {
    const bool grounded = treated_ != matrix_;
    Solution solution;
    if (treated_->rows() == 0)
        solution.columns = DenseMatrix::Zero(treated_->rows(), B.cols());
    else if (grounded)
        solution = apply_inverse(kernel_->restrict(B));
    else
        solution = apply_inverse(B);
    if (grounded)
        solution.columns = kernel_->extend(solution.columns);
    if (kernel_)
        solution.columns = kernel_->project_out(solution.columns);
    if (!solution.columns.allFinite())
        fail("the solution overflows: the matrix is singular to working precision\n"
             "If it has a kernel, give it in the facts.");
    return solution;
}

SolutionQuality CheckedSolver::measure(const DenseMatrix& X, const DenseMatrix& B,
                                       const DenseMatrix& R) const {
    SolutionQuality worst;
    for (Eigen::Index j = 0; j < B.cols(); ++j) {
        const double r = R.col(j).lpNorm<Eigen::Infinity>();
        const double b = B.col(j).lpNorm<Eigen::Infinity>();
        const double x = X.col(j).lpNorm<Eigen::Infinity>();
        const double residual = ratio(length(R.col(j), r), length(B.col(j), b));
        worst.residual = worse(worst.residual, residual);
        worst.backward_error = worse(worst.backward_error, ratio(r, matrix_norm_ * x + b));
    }
    return worst;
}

bool CheckedSolver::is_good(const SolutionQuality& quality) const {
    return quality.is_good(traits_.method == Method::iterative ? 10.0 * options_.tolerance : 0.0);
}

CheckedSolver::Solution CheckedSolver::solve_checked(const DenseMatrix& B) {
    Solution solution = invert(B);
    DenseMatrix R = B;
    R.noalias() -= *matrix_ * solution.columns;
    SolutionQuality quality = measure(solution.columns, B, R);

    // Where inertia is wanted, refinement would hide the sign of a count not to be trusted.
    if (inertia_ == Inertia::unneeded && !is_good(quality) && R.allFinite()) {
        const Solution correction = invert(kernel_ ? kernel_->project_out(R) : R);
        solution.columns += correction.columns;
        solution.iterations += correction.iterations;
        R = B;
        R.noalias() -= *matrix_ * solution.columns;
        quality = measure(solution.columns, B, R);
    }
    if (!R.allFinite() || (inertia_ == Inertia::unneeded && !is_good(quality)))
        fail(quality.failure(), SolveReport::failed(name_, solution.iterations, quality.residual,
                                                    quality.backward_error));
    report_ = {name_, solution.iterations, quality.residual, quality.backward_error, {name_}};
    return solution;
}

DenseMatrix CheckedSolver::solve_columns(const Eigen::Ref<const DenseMatrix>& B) {
    check_right_hand_side(B);
    report_ = {name_, 0, 0.0, 0.0, {name_}};
    if (B.size() == 0)
        return B;
    return within_memory("solve with", matrix_->rows(), [&] { return solve_valid(B); });
}

DenseMatrix CheckedSolver::solve_valid(const Eigen::Ref<const DenseMatrix>& B) {
    std::vector<int> exponents;
    for (Eigen::Index j = 0; j < B.cols(); ++j)
        exponents.push_back(exponent_to_remove(B.col(j).lpNorm<Eigen::Infinity>()));
    if (exponent_ == 0 && std::all_of(exponents.begin(), exponents.end(), std::logical_not<>()))
        return solve_scaled(B);

    DenseMatrix scaled = B;
    for (Eigen::Index j = 0; j < B.cols(); ++j)
        scale(scaled.col(j), -exponents[j]);
    DenseMatrix X = solve_scaled(scaled);
    for (Eigen::Index j = 0; j < B.cols(); ++j)
        scale(X.col(j), exponents[j] - exponent_);
    if (!X.allFinite())
        fail("the solution overflows: scale the right-hand side down");
    return X;
}

DenseMatrix CheckedSolver::solve_scaled(const Eigen::Ref<const DenseMatrix>& B) {
    if (!kernel_)
        return solve_checked(B).columns;

    // The part in the kernel is what no solution can give: rounding is taken away, more refused.
    const DenseMatrix consistent = kernel_->project_out(B);
    for (Eigen::Index j = 0; j < B.cols(); ++j) {
        const double part =
            ratio((B.col(j) - consistent.col(j)).stableNorm(), B.col(j).stableNorm());
        if (!(part <= kernel_limit))
            throw InvalidInput(fmt::format(
                "{}: right-hand side {} has a part in the kernel of the matrix, {:.2g} of its "
                "norm\n"
                "No solution exists; remove this part (for Neumann data: make the mean 0).",
                name_, j, part));
    }
    return solve_checked(consistent).columns;
}

} // namespace polydec
