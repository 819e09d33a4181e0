// SPDX-License-Identifier: MIT
#include "tests/backends/matrices.h"

namespace polydec::test::in_linear_contract {

/// What every linear engine promises, whichever it is.
class LinearContract : public testing::TestWithParam<std::string> {
protected:
    std::unique_ptr<LinearSolver> make(const LinearSolverOptions& options = {}) const {
        return make_linear_solver(GetParam(), options);
    }

    /// Whether the engine's traits allow these facts.
    bool takes(const MatrixFacts& facts) const {
        const EngineTraits traits = make()->traits();
        if (facts.symmetry == Symmetry::general)
            return traits.symmetry == Symmetry::general;
        return facts.definiteness <= traits.definiteness &&
               (facts.inertia == Inertia::unneeded || traits.inertia == Inertia::wanted);
    }

    /// Solves where the engine takes such a matrix, and is refused where it does not.
    void expect_solves(const SparseMatrix& A, const MatrixFacts& facts, const DenseMatrix& B) {
        const auto solver = make();
        if (!takes(facts)) {
            EXPECT_THROW(solver->factorize(A, facts), InvalidInput);
            return;
        }
        solver->factorize(A, facts);
        EXPECT_PRED3(solves, A, solver->solve(B), B);
        EXPECT_LE(solver->report().residual, 1e-9);
        EXPECT_LE(solver->report().backward_error, 1e-10);
        EXPECT_FALSE(solver->report().tried.empty());
    }
};

TEST_P(LinearContract, systems_of_every_kind_are_solved_by_engines_that_take_them) {
    expect_solves(grid_laplacian(20), positive(), random_matrix(400, 1, 1));
    expect_solves(grid_laplacian(8, 3), positive(), random_matrix(512, 1, 2));
    expect_solves(grid_laplacian(12), general(), random_matrix(144, 1, 3));
    expect_solves(shifted(grid_laplacian(12), 3.1), indefinite(), random_matrix(144, 2, 9));
    for (const double peclet : {0.9, 20.0})
        expect_solves(convection_diffusion(15, peclet), general(), random_matrix(225, 1, 10));
    SparseMatrix A = grid_laplacian(5);
    A.uncompress();
    expect_solves(A, positive(), random_matrix(25, 1, 18));
}

TEST_P(LinearContract, several_right_hand_sides_are_solved_at_once) {
    const auto A = grid_laplacian(12);
    DenseMatrix B = random_matrix(144, 9, 4);
    B.col(3).setZero();
    expect_solves(A, positive(), B);

    const auto solver = make();
    solver->factorize(A, positive());
    EXPECT_TRUE(solver->solve(B).col(3).isZero(0.0));
    EXPECT_EQ(solver->solve(DenseMatrix(144, 0)).cols(), 0);
}

TEST_P(LinearContract, systems_of_every_size_have_the_same_digits) {
    const auto A = grid_laplacian(12);
    const DenseMatrix B = random_matrix(144, 2, 5);
    const auto solver = make();
    solver->factorize(A, positive());
    const DenseMatrix X = solver->solve(B);
    for (const int of_matrix : {-900, -600, 0, 600, 900})
        for (const int of_side : {-900, -600, 0, 600, 900}) {
            if (std::abs(of_side - of_matrix) > 1000)
                continue; // the solution is no number
            solver->factorize(SparseMatrix(std::exp2(of_matrix) * A), positive());
            const DenseMatrix found = solver->solve(std::exp2(of_side) * B);
            EXPECT_LE((std::exp2(of_matrix - of_side) * found - X).norm(), 1e-9 * X.norm())
                << "2^" << of_matrix << ", 2^" << of_side;
            EXPECT_LE(solver->report().residual, 1e-9);
        }
}

TEST_P(LinearContract, solutions_beyond_the_range_of_numbers_are_refused) {
    const auto solver = make();
    solver->factorize(SparseMatrix(std::exp2(-700) * grid_laplacian(4)), positive());
    EXPECT_THROW(solver->solve(std::exp2(700) * Vector::Ones(16)), SolverFailure);
}

TEST_P(LinearContract, vectors_blocks_and_expressions_are_right_hand_sides) {
    const auto A = grid_laplacian(6);
    const auto solver = make();
    solver->factorize(A, positive());
    const DenseMatrix B = random_matrix(36, 3, 5);
    const DenseMatrix X = solver->solve(B);
    const Vector x = solver->solve(B.col(1));
    EXPECT_LE((x - X.col(1)).norm(), 1e-9 * x.norm());
    const Vector y = solver->solve(2.0 * B.col(1));
    EXPECT_LE((y - 2.0 * X.col(1)).norm(), 1e-9 * x.norm());
}

TEST_P(LinearContract, semidefinite_systems_with_known_kernel_are_solved_orthogonally_to_it) {
    const auto A = neumann_laplacian(15);
    const Vector ones = Vector::Ones(225);
    DenseMatrix B = random_matrix(225, 3, 6);
    B.rowwise() -= B.colwise().mean().eval();
    expect_solves(A, semidefinite(ones), B);

    const auto solver = make();
    solver->factorize(A, semidefinite(ones));
    const DenseMatrix X = solver->solve(B);
    EXPECT_LE((ones.transpose() * X).norm(), 1e-9 * X.norm());
}

TEST_P(LinearContract, kernels_of_several_components_are_taken_out) {
    DenseMatrix two = DenseMatrix::Zero(32, 32);
    two.topLeftCorner(16, 16) = neumann_laplacian(4);
    two.bottomRightCorner(16, 16) = 1e-3 * DenseMatrix(neumann_laplacian(4));
    DenseMatrix kernel = DenseMatrix::Ones(32, 2);
    kernel.col(1).tail(16).setConstant(-3.0);
    const auto A = sparse(two);
    expect_solves(A, semidefinite(kernel), A * random_matrix(32, 2, 7));
}

TEST_P(LinearContract, right_hand_sides_outside_the_image_are_refused) {
    const auto A = neumann_laplacian(6);
    const auto solver = make();
    solver->factorize(A, semidefinite(Vector::Ones(36)));
    EXPECT_REFUSED(solver->solve(Vector::Ones(36)), "right-hand side 0", "kernel", "1");
}

TEST_P(LinearContract, unknown_kernels_give_a_solution_or_an_error_but_no_garbage) {
    const auto A = neumann_laplacian(9);
    const DenseMatrix in_image = A * random_matrix(81, 1, 8);
    const Vector outside = Vector::LinSpaced(81, 0.9, 1.1);
    for (const auto& facts : {semidefinite(), positive()}) {
        const auto solver = make();
        try {
            solver->factorize(A, facts);
            EXPECT_PRED3(solves, A, solver->solve(in_image), in_image);
        } catch (const SolverFailure&) {
            continue;
        }
        EXPECT_THROW(solver->solve(outside), SolverFailure);
    }
}

TEST_P(LinearContract, zero_matrices_are_solved_for_zero_or_refused) {
    const SparseMatrix zero(5, 5);
    for (const auto& facts : {general(), positive(), semidefinite(), indefinite()}) {
        if (!takes(facts))
            continue;
        const auto solver = make();
        try {
            solver->factorize(zero, facts);
            EXPECT_TRUE(solver->solve(Vector::Zero(5)).isZero(0.0));
        } catch (const SolverFailure&) {
            continue;
        }
        EXPECT_THROW(solver->solve(Vector::Ones(5)), SolverFailure);
    }
}

TEST_P(LinearContract, a_matrix_that_is_all_kernel_gives_zero) {
    const SparseMatrix zero(3, 3);
    const auto solver = make();
    solver->factorize(zero, semidefinite(DenseMatrix::Identity(3, 3)));
    EXPECT_TRUE(solver->solve(Vector::Zero(3)).isZero(0.0));
    EXPECT_THROW(solver->solve(Vector::Unit(3, 0)), InvalidInput);
}

TEST_P(LinearContract, a_matrix_that_is_not_what_it_is_called_is_no_silent_wrong_answer) {
    const Vector b = random_matrix(100, 1, 12);
    const auto windy = convection_diffusion(10, 0.9), negative = shifted(grid_laplacian(10), 2.0);
    for (const auto& [A, facts] :
         {std::pair{windy, positive()}, {windy, indefinite()}, {negative, positive()}}) {
        if (!takes(facts))
            continue;
        const auto solver = make({.max_iterations = 2000});
        try {
            solver->factorize(A, facts);
            EXPECT_PRED3(solves, A, solver->solve(b), b);
        } catch (const SolverFailure& failure) {
            EXPECT_NE(std::string(failure.what()).find(solver->name()), std::string::npos);
        }
    }
}

TEST_P(LinearContract, empty_systems_have_empty_solutions) {
    const auto solver = make();
    solver->factorize(SparseMatrix(0, 0), positive());
    EXPECT_EQ(solver->solve(Vector(0)).size(), 0);
    EXPECT_EQ(solver->solve(DenseMatrix(0, 4)).cols(), 4);
}

TEST_P(LinearContract, one_by_one_systems_are_divisions) {
    const auto solver = make();
    solver->factorize(sparse(DenseMatrix::Constant(1, 1, 4.0)), positive());
    EXPECT_DOUBLE_EQ(solver->solve(Vector::Constant(1, 8.0))[0], 2.0);
    EXPECT_DOUBLE_EQ(solver->solve(Vector::Constant(1, 8e-200))[0], 2e-200);
}

TEST_P(LinearContract, matrices_that_are_not_square_are_refused) {
    const auto solver = make();
    const SparseMatrix A(3, 4);
    EXPECT_REFUSED(solver->factorize(A, positive()), "3 x 4", "square");
}

TEST_P(LinearContract, nan_and_infinity_are_refused_by_name) {
    const auto solver = make();
    SparseMatrix A = grid_laplacian(3);
    A.coeffRef(2, 5) = std::nan("");
    EXPECT_REFUSED(solver->factorize(A, positive()), "(2, 5)", "matrix", "nan");

    solver->factorize(grid_laplacian(3), positive());
    DenseMatrix B = DenseMatrix::Ones(9, 2);
    B(7, 1) = -std::numeric_limits<double>::infinity();
    EXPECT_REFUSED(solver->solve(B), "entry 7", "right-hand side 1", "-inf");
}

TEST_P(LinearContract, solving_needs_a_factorization_and_the_right_size) {
    const auto solver = make();
    EXPECT_REFUSED(solver->solve(Vector::Ones(3)), GetParam(), "factorize", "solve");
    solver->factorize(grid_laplacian(3), positive());
    EXPECT_REFUSED(solver->solve(Vector::Ones(3)), "right-hand side", "3 rows", "9 x 9");

    EXPECT_THROW(solver->factorize(SparseMatrix(2, 3), positive()), InvalidInput);
    EXPECT_THROW(solver->solve(Vector::Ones(9)), InvalidInput);
}

TEST_P(LinearContract, refactorization_forgets_the_matrix_before) {
    const auto solver = make();
    const auto first = grid_laplacian(10);
    const SparseMatrix same_pattern = shifted(3.0 * first, -1.0);
    const auto other = grid_laplacian(4, 3);
    for (const auto* A : {&first, &same_pattern, &other, &first}) {
        solver->factorize(*A, positive());
        const DenseMatrix B = random_matrix(static_cast<Index>(A->rows()), 2, 15);
        EXPECT_PRED3(solves, *A, solver->solve(B), B);
    }
    if (!takes(indefinite()))
        return;
    for (const auto& facts : {indefinite(), positive(), indefinite()}) {
        solver->factorize(first, facts);
        const DenseMatrix B = random_matrix(100, 1, 16);
        EXPECT_PRED3(solves, first, solver->solve(B), B);
    }
}

TEST_P(LinearContract, a_failed_factorization_does_not_spoil_the_next) {
    const auto solver = make();
    DenseMatrix singular = DenseMatrix::Zero(2, 2);
    singular(0, 1) = singular(1, 0) = 1.0;
    try {
        solver->factorize(sparse(singular), positive());
    } catch (const SolverFailure&) {
        EXPECT_THROW(solver->solve(Vector::Ones(2)), InvalidInput);
    }
    const auto A = grid_laplacian(4);
    const DenseMatrix B = random_matrix(16, 1, 17);
    solver->factorize(A, positive());
    EXPECT_PRED3(solves, A, solver->solve(B), B);
}

TEST_P(LinearContract, what_an_engine_cannot_do_is_refused) {
    MatrixFacts facts = positive();
    facts.inertia = Inertia::wanted;
    const auto solver = make();
    if (takes(facts)) {
        solver->factorize(grid_laplacian(4), facts);
        EXPECT_EQ(solver->negative_pivots(), Index{0});
    } else {
        EXPECT_THROW(solver->factorize(grid_laplacian(4), facts), InvalidInput);
    }
    EXPECT_THROW(make({.tolerance = 0.0}), InvalidInput);
    EXPECT_THROW(make({.tolerance = std::nan("")}), InvalidInput);
    EXPECT_THROW(make({.max_iterations = -1}), InvalidInput);
}

TEST_P(LinearContract, what_is_not_a_kernel_is_refused) {
    const auto A = neumann_laplacian(4);
    const auto solver = make();
    for (const DenseMatrix& wrong :
         {DenseMatrix(Vector::LinSpaced(16, 0.0, 1.0)), DenseMatrix(DenseMatrix::Ones(16, 2)),
          DenseMatrix(Vector::Ones(15)), DenseMatrix(Vector::Zero(16)),
          DenseMatrix(Vector::Constant(16, std::nan("")))})
        EXPECT_THROW(solver->factorize(A, semidefinite(wrong)), InvalidInput);

    MatrixFacts of_general = general();
    of_general.kernel = Vector::Ones(16);
    EXPECT_THROW(solver->factorize(A, of_general), InvalidInput);
}

INSTANTIATE_TEST_SUITE_P(engines, LinearContract, testing::ValuesIn(linear_engine_names()),
                         [](const auto& test) { return test_name(test.param); });

} // namespace polydec::test::in_linear_contract
