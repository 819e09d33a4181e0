// SPDX-License-Identifier: MIT
#include "tests/backends/matrices.h"

#include <Eigen/IterativeLinearSolvers>

namespace polydec::test::in_adapt {

/// The broken twin: every solution is wrong in the fourth digit.
struct WrongLu : DenseLu {
    DenseMatrix solve(const DenseMatrix& B) const { return 1.0001 * lu.solve(B); }
};

/// Wrong, but only by so much that one step of refinement mends it.
struct SloppyLu : DenseLu {
    DenseMatrix solve(const DenseMatrix& B) const { return (1.0 + 1e-6) * lu.solve(B); }
};

TEST(adapt, any_type_with_compute_and_solve_is_an_engine) {
    const auto solver = adapt<DenseLu>("mine")({});
    const auto A = convection_diffusion(6, 3.0);
    const DenseMatrix B = random_matrix(36, 2, 1);
    solver->factorize(A, general());
    EXPECT_PRED3(solves, A, solver->solve(B), B);
    EXPECT_EQ(solver->name(), "mine");
    EXPECT_EQ(solver->negative_pivots(), std::nullopt);
}

TEST(adapt, wrong_solutions_are_caught) {
    const auto A = grid_laplacian(6);
    const Vector b = random_matrix(36, 1, 2);
    const auto solver = adapt<WrongLu>("wrong")({});
    solver->factorize(A, positive());
    EXPECT_ERROR(SolverFailure, solver->solve(b), "wrong", "solution", "|b - A x| / |b|");
}

TEST(adapt, one_step_of_refinement_mends_sloppy_solutions) {
    const auto A = grid_laplacian(6);
    const Vector b = random_matrix(36, 1, 3);
    const auto solver = adapt<SloppyLu>("sloppy")({});
    solver->factorize(A, positive());
    EXPECT_PRED3(solves, A, solver->solve(b), b);
    EXPECT_LE(solver->report().backward_error, 1e-10);
}

TEST(adapt, refinement_does_not_hide_a_bad_factorization_where_inertia_counts) {
    const EngineTraits traits{.inertia = Inertia::wanted};
    const auto solver = adapt<SloppyLu>("sloppy", traits)({});
    solver->factorize(grid_laplacian(6), counted());
    solver->solve(random_matrix(36, 1, 4));
    EXPECT_GE(solver->report().backward_error, 1e-9);
}

TEST(adapt, failures_of_the_engine_are_ours) {
    const auto solver = adapt<Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower | Eigen::Upper>>(
        "cg", {.method = Method::iterative, .symmetry = Symmetry::symmetric},
        [](auto& cg) { cg.setMaxIterations(2); })({});
    solver->factorize(grid_laplacian(9), positive());
    EXPECT_ERROR(SolverFailure, solver->solve(random_matrix(81, 1, 5)), "cg", "converge",
                 "iterations");
}

TEST(adapt, adapted_engines_can_be_registered) {
    register_engine("mine.registered", adapt<DenseLu>("mine.registered"));
    EXPECT_TRUE(has_linear_solver("mine.registered"));
    EXPECT_EQ(make_linear_solver("mine.registered")->name(), "mine.registered");
}

} // namespace polydec::test::in_adapt
