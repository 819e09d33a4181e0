// SPDX-License-Identifier: MIT
#include "backends/linear/auto_solver.h"

#include "tests/backends/matrices.h"

namespace polydec::test::in_auto_solver {

using Names = std::vector<std::string>;

/// The names without those that not every program has.
Names suitable(const SparseMatrix& A, const MatrixFacts& facts) {
    Names names = suitable_engines(A, facts);
    std::erase_if(names, [](const std::string& name) {
        return name == "cholmod" || name.starts_with("petsc.");
    });
    return names;
}

TEST(auto_solver, the_facts_decide) {
    const auto A = grid_laplacian(4);
    EXPECT_EQ(suitable(A, positive()), (Names{"eigen.ldlt", "eigen.lu", "eigen.cg"}));
    EXPECT_EQ(suitable(A, semidefinite(Vector::Ones(16))),
              (Names{"eigen.ldlt", "eigen.lu", "eigen.cg"}));
    EXPECT_EQ(suitable(A, semidefinite()), (Names{"eigen.cg", "eigen.ldlt"}));
    EXPECT_EQ(suitable(A, indefinite()), (Names{"eigen.ldlt", "eigen.lu"}));
    EXPECT_EQ(suitable(A, counted()), (Names{"eigen.ldlt"}));
    EXPECT_EQ(suitable(A, general()), (Names{"eigen.lu", "eigen.bicgstab"}));
}

TEST(auto_solver, large_solids_are_iterated) {
    const SparseMatrix A(1000000, 1000000);
    MatrixFacts facts = positive();
    facts.domain_dimension = 3;
    EXPECT_EQ(suitable(A, facts).front(), "eigen.cg");
    facts.domain_dimension = 2;
    EXPECT_NE(suitable(A, facts).front(), "eigen.cg");
}

TEST(auto_solver, multigrid_goes_before_all_else_for_large_solids_where_it_is_there) {
    Names there;
    for (const char* name : {"petsc.cg-hypre", "petsc.cg-gamg"})
        if (has_linear_solver(name))
            there.push_back(name);
    const auto first = [&](Index size, int dimension, MatrixFacts facts) {
        facts.domain_dimension = dimension;
        Names names = suitable_engines(SparseMatrix(size, size), facts);
        names.resize(there.size());
        return names;
    };
    EXPECT_EQ(first(40000, 3, positive()), there);
    EXPECT_EQ(first(40000, 4, semidefinite()), there);
    MatrixFacts often = positive();
    often.many_solves = true;
    EXPECT_EQ(first(400000, 3, often), there);
    for (const auto& others : {first(40000, 3, often), first(20000, 3, positive()),
                               first(40000, 2, positive()), first(40000, 3, indefinite())})
        EXPECT_TRUE(there.empty() || others != there);
}

TEST(auto_solver, short_steps_on_solids_are_iterated) {
    const auto first = [](int dimension, Index size, double beside) {
        std::vector<Eigen::Triplet<double, Index>> entries;
        for (Index i = 0; i < size; ++i) {
            const Index next = (i + 1) % size;
            entries.insert(entries.end(), {{i, i, 4}, {i, next, beside}, {next, i, beside}});
        }
        SparseMatrix A(size, size);
        A.setFromTriplets(entries.begin(), entries.end());
        MatrixFacts facts = positive();
        facts.domain_dimension = dimension;
        facts.many_solves = true;
        return suitable_engines(A, facts).front();
    };
    EXPECT_EQ(first(3, 6000, -1), "eigen.cg");
    for (const auto& other : {first(3, 6000, -1.1), first(2, 6000, -1), first(3, 4000, -1)})
        EXPECT_NE(other, "eigen.cg");
}

TEST(auto_solver, surfaces_go_to_multigrid_once_they_are_very_large_or_memory_is_short) {
    if (!has_linear_solver("petsc.cg-gamg"))
        return;
    const auto place = [](Index size, MatrixFacts facts) {
        facts.domain_dimension = 2;
        const Names names = suitable_engines(SparseMatrix(size, size), facts);
        return std::find(names.begin(), names.end(), "petsc.cg-gamg") - names.begin();
    };
    MatrixFacts often = positive();
    often.many_solves = true;
    EXPECT_EQ(place(2000000, positive()), 0);
    EXPECT_EQ(place(2000000, often), 1);
    EXPECT_EQ(place(1000000, positive()), 1);
    EXPECT_GT(place(1000, positive()), 1); // is not among them
}

TEST(auto_solver, factors_beyond_the_memory_limit_leave_the_work_to_an_iterative_engine) {
    const SparseMatrix A = grid_laplacian(100);
    const auto any = make_linear_solver("auto"), ldlt = make_linear_solver("eigen.ldlt");
    set_memory_limit(1000000);
    const auto told = message_of<OutOfMemory>([&] { ldlt->factorize(A, positive()); });
    any->factorize(A, positive());
    const Vector x = any->solve(Vector::Ones(A.rows()));
    set_memory_limit(machine_memory());
    EXPECT_SAYS(told, "eigen.ldlt", "10000 x 10000", "1 MB");
    const auto engine = any->report().engine;
    EXPECT_EQ(make_linear_solver(engine)->traits().method, Method::iterative) << engine;
    EXPECT_LT((A * x - Vector::Ones(A.rows())).norm(), 1e-6 * x.norm());
}

TEST(auto_solver, it_names_better_engines_that_are_missing_where_work_is_large) {
    MatrixFacts facts = positive();
    facts.domain_dimension = 2;
    const auto large = missed_engines(SparseMatrix(100000, 100000), facts);
    if (has_linear_solver("cholmod"))
        EXPECT_EQ(large, "");
    else
        EXPECT_SAYS(large, "auto", "cholmod", "100000", "libsuitesparse-dev");
    EXPECT_EQ(missed_engines(SparseMatrix(1000, 1000), facts), "");
    EXPECT_EQ(missed_engines(SparseMatrix(100000, 100000), general()), "");
}

TEST(auto_solver, what_it_missed_is_given_once) {
    SparseMatrix A(60000, 60000);
    A.setIdentity();
    for (int time = 0; time < 2; ++time) {
        const auto solver = make_linear_solver("auto");
        solver->factorize(A, positive());
        take_missed_engines();
        EXPECT_EQ(take_missed_engines(), "");
    }
}

TEST(auto_solver, it_reports_who_delivered) {
    const auto solver = make_linear_solver("auto");
    const auto A = grid_laplacian(8);
    solver->factorize(A, positive());
    const Vector b = random_matrix(64, 1, 1);
    solver->solve(b);
    EXPECT_EQ(solver->report().engine, suitable_engines(A, positive()).front());
    EXPECT_EQ(solver->report().tried, Names{solver->report().engine});
}

// A zero pivot stops every L D L^T without pivoting, and nothing else is wrong with this matrix.
TEST(auto_solver, it_goes_on_to_the_next_engine_and_says_so) {
    DenseMatrix swap = DenseMatrix::Zero(4, 4);
    swap(0, 1) = swap(1, 0) = swap(2, 3) = swap(3, 2) = 1.0;
    const auto A = sparse(swap);
    const auto solver = make_linear_solver("auto");
    solver->factorize(A, indefinite());
    const Vector b = random_matrix(4, 1, 2);
    EXPECT_PRED3(solves, A, solver->solve(b), b);
    EXPECT_EQ(solver->report().engine, "eigen.lu");
    ASSERT_GE(solver->report().tried.size(), 2u);
    const auto& failure = solver->report().tried[solver->report().tried.size() - 2];
    EXPECT_SAYS(failure, "eigen.ldlt", "pivot", "singular");
    EXPECT_EQ(solver->report().tried.back(), "eigen.lu");
}

TEST(auto_solver, a_pinned_engine_does_not_go_on) {
    DenseMatrix swap = DenseMatrix::Zero(2, 2);
    swap(0, 1) = swap(1, 0) = 1.0;
    const auto solver = make_linear_solver("eigen.ldlt");
    EXPECT_THROW(solver->factorize(sparse(swap), indefinite()), SolverFailure);
}

TEST(auto_solver, when_no_engine_is_left_the_error_tells_of_all) {
    const auto solver = make_linear_solver("auto");
    SparseMatrix A(3, 3);
    A.insert(0, 0) = 1.0;
    const auto message = message_of<SolverFailure>([&] { solver->factorize(A, indefinite()); });
    EXPECT_SAYS(message, "auto", "no engine", "3 x 3");
    EXPECT_SAYS(message, "eigen.ldlt", "pivot");
    EXPECT_SAYS(message, "eigen.lu", "singular", "row 1");
    EXPECT_THROW(solver->solve(Vector::Ones(3)), InvalidInput);
}

TEST(auto_solver, a_hopeless_right_hand_side_does_not_spoil_the_next) {
    const auto solver = make_linear_solver("auto");
    const auto A = neumann_laplacian(8);
    solver->factorize(A, semidefinite());
    EXPECT_THROW(solver->solve(Vector::LinSpaced(64, 0.5, 1.0)), SolverFailure);
    const DenseMatrix b = A * random_matrix(64, 1, 3);
    EXPECT_PRED3(solves, A, solver->solve(b), b);
}

TEST(auto_solver, it_counts_negative_eigenvalues_where_asked) {
    const auto solver = make_linear_solver("auto");
    EXPECT_EQ(solver->negative_pivots(), std::nullopt);
    const auto A = shifted(grid_laplacian(7), 2.5);
    solver->factorize(A, counted());
    EXPECT_EQ(solver->negative_pivots(), negative_eigenvalues(A));
}

} // namespace polydec::test::in_auto_solver
