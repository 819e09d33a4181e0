// SPDX-License-Identifier: MIT
#include "tests/backends/matrices.h"

#include <rapidcheck/gtest.h>

#include <new>

namespace polydec::test::in_checked_solver {

/// Tells whether it was told that the pattern is the same; and leaves a trace of what it was given.
class Spy final : public CheckedSolver {
public:
    Spy() : CheckedSolver("spy", {}, {}) {}
    bool was_same = false;
    Eigen::Index size = -1;
    Definiteness definiteness = Definiteness::indefinite;

protected:
    void compute(const SparseMatrix& A, const MatrixFacts& facts, Pattern pattern) override {
        was_same = pattern == Pattern::same;
        size = A.rows();
        definiteness = facts.definiteness;
        lu_.compute(DenseMatrix(A));
    }
    Solution apply_inverse(const DenseMatrix& B) override { return {lu_.solve(B)}; }

private:
    Eigen::PartialPivLU<DenseMatrix> lu_;
};

TEST(checked_solver, the_analysis_is_kept_for_equal_patterns_only) {
    Spy spy;
    spy.factorize(grid_laplacian(4), positive());
    EXPECT_FALSE(spy.was_same);
    spy.factorize(2.0 * grid_laplacian(4), positive());
    EXPECT_TRUE(spy.was_same);
    spy.factorize(neumann_laplacian(4), semidefinite(Vector::Ones(16)));
    EXPECT_FALSE(spy.was_same);
    spy.factorize(3.0 * neumann_laplacian(4), semidefinite(Vector::Ones(16)));
    EXPECT_TRUE(spy.was_same);
}

TEST(checked_solver, known_kernels_leave_a_smaller_definite_matrix) {
    Spy spy;
    spy.factorize(neumann_laplacian(4), semidefinite(Vector::Ones(16)));
    EXPECT_EQ(spy.size, 15);
    EXPECT_EQ(spy.definiteness, Definiteness::positive);
}

TEST(checked_solver, the_check_of_the_tests_catches_wrong_solutions) {
    const auto A = grid_laplacian(5);
    const DenseMatrix X = random_matrix(25, 2, 1);
    const DenseMatrix B = A * X;
    EXPECT_TRUE(solves(A, X, B));
    EXPECT_FALSE(solves(A, (1.0 + 1e-7) * X, B));
    EXPECT_FALSE(solves(A, X.leftCols(1), B));
    DenseMatrix hole = X;
    hole(3, 1) = std::nan("");
    EXPECT_FALSE(solves(A, hole, B));
}

/// Has no memory, for factorizing or for solving alone.
class Greedy final : public CheckedSolver {
public:
    Greedy(bool while_factorizing, Method method)
        : CheckedSolver("greedy", {.method = method}, {}), while_factorizing_(while_factorizing) {}

protected:
    void compute(const SparseMatrix&, const MatrixFacts&, Pattern) override {
        if (while_factorizing_)
            throw std::bad_alloc();
    }
    Solution apply_inverse(const DenseMatrix&) override { throw std::bad_alloc(); }

private:
    bool while_factorizing_;
};

TEST(checked_solver, want_of_memory_names_the_engine_and_what_it_was_for) {
    Greedy direct(true, Method::direct), iterative(false, Method::iterative);
    EXPECT_ERROR(OutOfMemory, direct.factorize(grid_laplacian(4), positive()), "greedy", "memory",
                 "factorize", "16 x 16", "iterative");
    EXPECT_THROW(direct.solve(Vector::Ones(16)), InvalidInput);
    iterative.factorize(grid_laplacian(4), positive());
    EXPECT_ERROR(OutOfMemory, iterative.solve(Vector::Ones(16)), "greedy", "memory", "solve",
                 "16 x 16");
}

/// Knows that its factor takes 3 MB.
class Foresighted final : public CheckedSolver {
public:
    Foresighted() : CheckedSolver("foresighted", {}, {}) {}

protected:
    void compute(const SparseMatrix& A, const MatrixFacts&, Pattern) override {
        check_factor(3e6, A.rows());
    }
    Solution apply_inverse(const DenseMatrix& B) override { return {B}; }
};

TEST(checked_solver, factors_that_exceed_the_limit_are_refused) {
    Foresighted solver;
    EXPECT_NO_THROW(solver.factorize(grid_laplacian(4), positive()));
    set_memory_limit(2000000);
    const auto told =
        message_of<OutOfMemory>([&] { solver.factorize(grid_laplacian(4), positive()); });
    set_memory_limit(machine_memory());
    EXPECT_SAYS(told, "foresighted", "16 x 16", "3 MB", "2 MB", "iterative");
}

/// Any sparse matrix: rows and columns may be empty, entries repeat, scales differ.
SparseMatrix any_matrix() {
    const auto size = *rc::gen::inRange(1, 13);
    const auto count = *rc::gen::inRange(0, 3 * size + 1);
    SparseMatrix A(size, size);
    for (int k = 0; k < count; ++k) {
        const auto i = *rc::gen::inRange(0, size);
        const auto j = *rc::gen::inRange(0, size);
        A.coeffRef(i, j) = *rc::gen::element(-2.0, -1.0, 0.0, 1.0, 1.0, 3.0, 1e-9, 1e9);
    }
    return A;
}

RC_GTEST_PROP(checked_solver, engines_solve_or_fail_but_never_give_garbage, ()) {
    SparseMatrix A = any_matrix();
    const bool symmetric = *rc::gen::arbitrary<bool>();
    if (symmetric)
        A = SparseMatrix(A + SparseMatrix(A.transpose()));
    const auto facts = symmetric ? *rc::gen::element(0, 1, 2) : 3;
    const MatrixFacts all[] = {positive(), semidefinite(), indefinite(), general()};
    const Vector b = random_matrix(static_cast<Index>(A.rows()), 1, *rc::gen::inRange(1u, 99u));

    for (const auto& name : linear_engine_names()) {
        const auto solver = make_linear_solver(name, {.max_iterations = 300});
        try {
            solver->factorize(A, all[facts]);
            const Vector x = solver->solve(b);
            RC_ASSERT(x.allFinite());
            RC_ASSERT((b - A * x).norm() <= 1e-6 * b.norm());
        } catch (const std::exception&) {
            continue;
        }
    }
}

RC_GTEST_PROP(checked_solver, regular_symmetric_systems_are_solved_by_every_engine_that_takes_them,
              ()) {
    const auto size = *rc::gen::inRange(1, 25);
    const DenseMatrix M = random_matrix(size, size, *rc::gen::inRange(1u, 9999u));
    const auto A = sparse(M * M.transpose() + DenseMatrix::Identity(size, size));
    const DenseMatrix B = random_matrix(size, *rc::gen::inRange(1, 4), 7);
    for (const auto& name : linear_engine_names()) {
        const auto solver = make_linear_solver(name);
        solver->factorize(A,
                          solver->traits().symmetry == Symmetry::general ? general() : positive());
        RC_ASSERT(solves(A, solver->solve(B), B));
    }
}

} // namespace polydec::test::in_checked_solver
