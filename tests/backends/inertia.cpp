// SPDX-License-Identifier: MIT
#include "tests/backends/matrices.h"

#include <rapidcheck/gtest.h>

namespace polydec::test::in_inertia {

std::vector<std::string> counting_engines() {
    std::vector<std::string> names;
    for (const auto& name : linear_engine_names())
        if (make_linear_solver(name)->traits().inertia == Inertia::wanted)
            names.push_back(name);
    return names;
}

class CountsNegative : public testing::TestWithParam<std::string> {};

TEST_P(CountsNegative, eigenvalues_of_grid_laplacians_below_every_gap) {
    for (const auto& [m, dimension] : {std::pair{9, 2}, std::pair{5, 3}}) {
        const auto A = grid_laplacian(m, dimension);
        const auto values = grid_eigenvalues(m, dimension);
        const auto solver = make_linear_solver(GetParam());
        for (std::size_t i = 0; i + 1 < values.size(); ++i) {
            if (values[i + 1] - values[i] < 1e-6)
                continue;
            const double tau = 0.5 * (values[i] + values[i + 1]);
            solver->factorize(shifted(A, tau), counted());
            EXPECT_EQ(solver->negative_pivots(), static_cast<Index>(i + 1)) << "tau = " << tau;
            solver->solve(Vector::Ones(A.rows()));
            EXPECT_LE(solver->report().backward_error, 1e-9);
        }
    }
}

// The broken twin: between the copies of a multiplet there is no gap, and the count is another one.
TEST_P(CountsNegative, a_shift_on_the_other_side_of_an_eigenvalue_is_told_apart) {
    const auto A = grid_laplacian(9);
    const auto values = grid_eigenvalues(9, 2);
    const auto solver = make_linear_solver(GetParam());
    solver->factorize(shifted(A, values[1] - 1e-9), counted());
    EXPECT_EQ(solver->negative_pivots(), Index{1});
    solver->factorize(shifted(A, values[1] + 1e-9), counted());
    EXPECT_EQ(solver->negative_pivots(), Index{3});
}

TEST_P(CountsNegative, zero_pivots_are_an_error) {
    const auto A = shifted(grid_laplacian(6), 4.0);
    const auto solver = make_linear_solver(GetParam());
    const auto message = message_of<SolverFailure>([&] { solver->factorize(A, counted()); });
    EXPECT_NE(message.find("zero pivot"), std::string::npos) << message;
    EXPECT_EQ(solver->negative_pivots(), std::nullopt);
}

TEST_P(CountsNegative, eigenvalues_beside_a_known_kernel) {
    MatrixFacts facts = semidefinite(Vector::Ones(36));
    facts.inertia = Inertia::wanted;
    const auto solver = make_linear_solver(GetParam());
    solver->factorize(neumann_laplacian(6), facts);
    EXPECT_EQ(solver->negative_pivots(), Index{0});
    solver->factorize(
        -neumann_laplacian(6),
        {.symmetry = Symmetry::symmetric, .inertia = Inertia::wanted, .kernel = Vector::Ones(36)});
    EXPECT_EQ(solver->negative_pivots(), Index{35});
}

INSTANTIATE_TEST_SUITE_P(engines, CountsNegative, testing::ValuesIn(counting_engines()),
                         [](const auto& test) { return test_name(test.param); });

RC_GTEST_PROP(inertia, sylvester_counts_what_a_dense_eigensolver_counts, ()) {
    const auto size = *rc::gen::inRange(1, 30);
    const auto seed = *rc::gen::inRange(1u, 99999u);
    const auto part = *rc::gen::inRange(1, 4); // one of so many entries stays
    DenseMatrix dense = random_symmetric(size, seed);
    for (Eigen::Index j = 0; j < size; ++j)
        for (Eigen::Index i = 0; i < j; ++i)
            if ((3 * i + 5 * j + seed) % part != 0)
                dense(i, j) = dense(j, i) = 0.0;
    const auto A = sparse(dense);
    for (const auto& name : counting_engines()) {
        const auto solver = make_linear_solver(name);
        solver->factorize(A, counted());
        RC_ASSERT(solver->negative_pivots() == negative_eigenvalues(A));
    }
}

} // namespace polydec::test::in_inertia
