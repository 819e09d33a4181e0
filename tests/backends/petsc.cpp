// SPDX-License-Identifier: MIT
#include "tests/backends/matrices.h"

#include <thread>

namespace polydec::test::in_petsc {

/// What the engines of PETSc promise beyond the contract of all linear engines.
class Petsc : public testing::TestWithParam<std::string> {
protected:
    static std::unique_ptr<LinearSolver> make(const std::string& options = {}) {
        return make_linear_solver(GetParam(), {.engine_options = options});
    }

    /// Iterations for a right-hand side in the image of A.
    static Index iterations(const SparseMatrix& A, const MatrixFacts& facts,
                            const std::string& options = {}) {
        const auto solver = make(options);
        solver->factorize(A, facts);
        const DenseMatrix B = A * random_matrix(static_cast<Index>(A.cols()), 1, 21);
        EXPECT_PRED3(solves, A, solver->solve(B), B);
        EXPECT_EQ(solver->report().engine, GetParam());
        return solver->report().iterations;
    }
};

TEST_P(Petsc, iterations_hardly_grow_with_the_matrix) {
    const Index small = iterations(grid_laplacian(10, 3), positive());
    const Index large = iterations(grid_laplacian(24, 3), positive());
    EXPECT_LE(large, small + 12);
    EXPECT_LE(large, 40);
}

TEST_P(Petsc, without_multigrid_iterations_grow) {
    const Index small = iterations(grid_laplacian(10, 3), positive(), "-pc_type jacobi");
    const Index large = iterations(grid_laplacian(24, 3), positive(), "-pc_type jacobi");
    EXPECT_GT(large, small + 12);
}

TEST_P(Petsc, options_concern_one_solver_alone) {
    const auto A = grid_laplacian(30);
    const Index before = iterations(A, positive());
    EXPECT_NE(iterations(A, positive(), "-pc_type none"), before);
    EXPECT_EQ(iterations(A, positive()), before);
}

TEST_P(Petsc, options_that_nobody_reads_are_refused) {
    const auto solver = make("-ksp_type fcg -ksp_rtoll 1e-9");
    EXPECT_REFUSED(solver->factorize(grid_laplacian(4), positive()), GetParam(), "option",
                   "-ksp_rtoll");
    EXPECT_REFUSED(make("ksp_type cg"), GetParam(), "ksp_type cg", "minus");
}

TEST_P(Petsc, options_with_values_that_do_not_exist_are_a_failure_with_the_reason_of_petsc) {
    const auto solver = make("-ksp_type abacus");
    const auto message =
        message_of<SolverFailure>([&] { solver->factorize(grid_laplacian(4), positive()); });
    EXPECT_SAYS(message, GetParam(), "options", "PETSc");
    EXPECT_NE(message.find("abacus"), std::string::npos) << message;
}

TEST_P(Petsc, a_loose_tolerance_among_the_options_does_not_pass_the_check) {
    const auto solver = make("-ksp_rtol 1e-2");
    const auto A = grid_laplacian(30);
    solver->factorize(A, positive());
    EXPECT_ERROR(SolverFailure, solver->solve(random_matrix(900, 1, 22)), "solution", "unreliable");
}

TEST_P(Petsc, failures_say_what_petsc_says) {
    const auto solver = make_linear_solver(GetParam(), {.max_iterations = 2});
    solver->factorize(grid_laplacian(40), positive());
    EXPECT_ERROR(SolverFailure, solver->solve(random_matrix(1600, 1, 23)), GetParam(),
                 "convergence", "2 iterations", "DIVERGED_ITS");
}

TEST_P(Petsc, a_kernel_costs_few_iterations_more) {
    const Index definite = iterations(grid_laplacian(40), positive());
    const Index semidefinite_ones =
        iterations(neumann_laplacian(40), semidefinite(Vector::Ones(1600)));
    EXPECT_LE(semidefinite_ones, definite + 8);
}

TEST_P(Petsc, a_kernel_that_is_not_known_costs_few_iterations_more) {
    EXPECT_LE(iterations(neumann_laplacian(40), semidefinite()),
              iterations(grid_laplacian(40), positive()) + 8);
}

// Gaussian elimination of the coarsest matrix goes astray along a kernel of which it knows nothing.
TEST(petsc, known_kernels_are_kept_out_of_what_multigrid_gives) {
    if (!has_linear_solver("petsc.cg-hypre"))
        return;
    const auto A = neumann_laplacian(150);
    const DenseMatrix B = A * random_matrix(22500, 1, 25);
    const auto solver = make_linear_solver(
        "petsc.cg-hypre",
        {.engine_options = "-pc_hypre_boomeramg_relax_type_coarse Gaussian-elimination"});
    solver->factorize(A, semidefinite(Vector::Ones(22500)));
    EXPECT_PRED3(solves, A, solver->solve(B), B);
    EXPECT_LE(solver->report().iterations, 25);
    solver->factorize(A, semidefinite());
    EXPECT_THROW(solver->solve(B), SolverFailure);
}

// As the Laplacian of a mesh with vertices that no simplex uses.
TEST_P(Petsc, unknowns_without_any_entries_are_in_the_kernel) {
    DenseMatrix with_holes = DenseMatrix::Zero(20, 20);
    with_holes.block(2, 2, 16, 16) = neumann_laplacian(4);
    DenseMatrix kernel = DenseMatrix::Zero(20, 5);
    kernel.col(0).segment(2, 16).setOnes();
    for (Index column = 1; const Index hole : {0, 1, 18, 19})
        kernel(hole, column++) = 1.0;
    const auto A = sparse(with_holes);
    iterations(A, semidefinite(kernel));
    iterations(A, semidefinite());
}

TEST_P(Petsc, a_negative_diagonal_is_named) {
    EXPECT_ERROR(SolverFailure, make()->factorize(shifted(grid_laplacian(4), 5.0), positive()),
                 GetParam(), "positive definite", "(0, 0)", "-1");
}

TEST_P(Petsc, solvers_of_several_threads_do_not_meet) {
    std::vector<std::thread> threads;
    std::vector<int> good(4, 0);
    for (Index t = 0; t < 4; ++t)
        threads.emplace_back([t, &good] {
            const auto A = grid_laplacian(10 + t);
            for (int i = 0; i < 5; ++i) {
                const auto solver = make(i % 2 ? "-ksp_type fcg" : "");
                solver->factorize(A, positive());
                const DenseMatrix B = random_matrix(static_cast<Index>(A.rows()), 1, 24);
                good[static_cast<std::size_t>(t)] += solves(A, solver->solve(B), B) ? 1 : 0;
            }
        });
    for (auto& thread : threads)
        thread.join();
    EXPECT_EQ(good, std::vector<int>(4, 5));
}

TEST_P(Petsc, no_signal_handler_stays_behind) {
    iterations(grid_laplacian(4), positive());
    for (const int signal : {SIGABRT, SIGINT, SIGTERM, SIGCHLD, SIGPIPE}) {
        struct sigaction action {};
        ASSERT_EQ(sigaction(signal, nullptr, &action), 0);
        EXPECT_EQ(action.sa_handler, SIG_DFL) << signal;
    }
}

std::vector<std::string> petsc_engine_names() {
    std::vector<std::string> names = linear_engine_names();
    std::erase_if(names, [](const std::string& name) { return !name.starts_with("petsc."); });
    return names;
}

INSTANTIATE_TEST_SUITE_P(engines, Petsc, testing::ValuesIn(petsc_engine_names()),
                         [](const auto& test) { return test_name(test.param); });

} // namespace polydec::test::in_petsc
