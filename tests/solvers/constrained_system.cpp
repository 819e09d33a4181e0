// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_constrained_system {

/// Laplacian of paths with the given numbers of nodes, side by side.
SparseMatrix paths(const std::vector<Index>& nodes) {
    std::vector<Eigen::Triplet<double, Index>> entries;
    Index first = 0;
    for (const Index part : nodes) {
        for (Index i = first; i + 1 < first + part; ++i)
            for (const Index end : {i, i + 1}) {
                entries.emplace_back(end, end, 1);
                entries.emplace_back(end, 2 * i + 1 - end, -1);
            }
        first += part;
    }
    SparseMatrix A(first, first);
    A.setFromTriplets(entries.begin(), entries.end());
    return A;
}

ConstrainedSystem system_of(const SparseMatrix& A, std::vector<bool> fixed) {
    const auto n = static_cast<std::size_t>(A.rows());
    return {A, std::move(fixed), std::vector<bool>(n, false), Vector::Ones(A.rows()),
            Definiteness::semidefinite};
}

Vector vector(const std::vector<double>& entries) {
    return Eigen::Map<const Vector>(entries.data(), static_cast<Index>(entries.size()));
}

TEST(ConstrainedSystem, with_everything_fixed_returns_what_it_is_given) {
    ConstrainedSolver solver(system_of(paths({3}), {true, true, true}), "auto");
    const auto found = solver.solve(vector({5, 5, 5}), vector({1, 2, 4}));
    EXPECT_EQ(found.values, vector({1, 2, 4}));
    EXPECT_EQ(found.report.residual, 0);
}

TEST(ConstrainedSystem, of_every_size_has_the_same_solution) {
    auto system = system_of(paths({4, 3}), {true, false, false, true, false, false, false});
    system.weights = vector({1, 1, 1, 1, 1, 2, 5});
    const Vector b = vector({0, 1, 2, 0, 3, 1, -2}), fixed = vector({1, 0, 0, 7, 0, 0, 0});
    const Vector u = ConstrainedSolver(system, "auto").solve(b, fixed).values;
    for (const double size : {0x1p-700, 0x1p-400, 0x1p400, 0x1p700}) {
        auto other = system;
        other.A *= size;
        other.weights *= size;
        ConstrainedSolver solver(other, "auto");
        const auto found = solver.solve(size * b, fixed);
        EXPECT_EQ(found.values, u);
        EXPECT_LE(found.report.residual, 1e-14);
    }
}

TEST(ConstrainedSystem, refuses_data_that_are_no_numbers) {
    ConstrainedSolver solver(system_of(paths({2}), {true, false}), "auto");
    const double huge = std::numeric_limits<double>::infinity();
    EXPECT_REFUSED(solver.solve(vector({0, huge}), vector({0, 0})), "right-hand side", "cell 1",
                   "inf");
    EXPECT_REFUSED(solver.solve(vector({0, 0}), vector({huge, 0})), "fixed values", "finite");
}

TEST(ConstrainedSystem, with_nothing_fixed_has_weighted_mean_zero) {
    auto system = system_of(paths({3}), {false, false, false});
    system.weights = vector({1, 2, 5});
    ConstrainedSolver solver(system, "auto");
    const auto [u, report, compatibility, warnings] =
        solver.solve(vector({1, 1, -2}), Vector::Zero(3));
    EXPECT_NEAR(system.weights.dot(u), 0, 1e-14);
    EXPECT_TRUE((system.A * u).isApprox(vector({1, 1, -2}), 1e-14));
    EXPECT_EQ(compatibility.free_components, 1);
    EXPECT_EQ(compatibility.worst, 0);
}

TEST(ConstrainedSystem, removes_in_proportion_to_the_weights_what_nothing_can_give) {
    auto system = system_of(paths({3}), {false, false, false});
    system.weights = vector({1, 2, 1});
    ConstrainedSolver solver(system, "auto");
    const auto [u, report, compatibility, warnings] =
        solver.solve(vector({4, 0, 0}), Vector::Zero(3));
    EXPECT_TRUE((system.A * u).isApprox(vector({3, -2, -1}), 1e-14));
    EXPECT_EQ(compatibility.worst, 1);
}

/// Else the solution of a constant source is noise, which pictures show in all colors.
TEST(ConstrainedSystem, leaves_nothing_of_what_is_as_the_weights_but_every_part_that_is_not) {
    constexpr Index size = 20000;
    const Vector weights = (1.5 + random_vector(size, 1).array()).matrix();
    const FreeComponents free(SparseMatrix(paths({size})), std::vector<bool>(size, false),
                              std::vector<bool>(size, false), weights);
    for (const double scale : {1.0, -1e-200, 3e200}) {
        Vector constant = scale * weights / 3;
        EXPECT_GT(free.balance(constant).worst, 0.99);
        EXPECT_TRUE(constant.isZero(0)) << scale;
        Vector more = scale * weights / 3;
        more[7] += 1e-10 * scale;
        free.balance(more);
        EXPECT_NEAR(more[7], 1e-10 * scale, 1e-13 * std::abs(scale));
    }
}

TEST(ConstrainedSystem, treats_each_component_by_itself) {
    // one held at an end, one free, one node alone
    auto system = system_of(paths({2, 2, 1}), {true, false, false, false, false});
    ConstrainedSolver solver(system, "auto");
    const auto [u, report, compatibility, warnings] =
        solver.solve(vector({0, 1, 1, -1, 0}), vector({10, 0, 0, 0, 0}));
    EXPECT_TRUE(u.isApprox(vector({10, 11, 0.5, -0.5, 0}), 1e-14)) << u;
    EXPECT_EQ(compatibility.free_components, 2);
}

TEST(ConstrainedSystem, is_regular_where_boundary_data_tie_it_down) {
    DenseMatrix A{{3, -1}, {-1, 1}};
    auto system = system_of(sparse(A), {false, false});
    system.tied = {true, false};
    ConstrainedSolver solver(system, "auto");
    const auto [u, report, compatibility, warnings] = solver.solve(vector({2, 0}), Vector::Zero(2));
    EXPECT_TRUE(u.isApprox(vector({1, 1}), 1e-14)) << u;
    EXPECT_EQ(compatibility.free_components, 0);
}

TEST(ConstrainedSystem, of_one_unknown_is_solved) {
    const SparseMatrix two = sparse(DenseMatrix::Constant(1, 1, 2.0));
    ConstrainedSolver fixed(system_of(two, {true}), "auto");
    EXPECT_EQ(fixed.solve(vector({8}), vector({3})).values, vector({3}));

    auto tied_system = system_of(two, {false});
    tied_system.tied = {true};
    ConstrainedSolver tied(tied_system, "auto");
    EXPECT_EQ(tied.solve(vector({8}), vector({0})).values, vector({4}));

    const ConstrainedSolver free(system_of(SparseMatrix(1, 1), {false}), "auto");
    const auto found = free.solve(vector({8}), vector({0}));
    EXPECT_EQ(found.values, vector({0}));
    EXPECT_EQ(found.compatibility.worst, 1);
}

TEST(ConstrainedSystem, is_solved_by_every_engine_that_takes_it) {
    for (const char* engine : {"auto", "eigen.ldlt", "eigen.lu", "eigen.cg"}) {
        ConstrainedSolver solver(system_of(paths({4}), {true, false, false, true}), engine);
        const auto found = solver.solve(Vector::Zero(4), vector({1, 99, 99, 7}));
        const bool is_direct = std::string_view(engine) != "eigen.cg";
        EXPECT_TRUE(found.values.isApprox(vector({1, 3, 5, 7}), is_direct ? 1e-14 : 1e-10))
            << engine;
        EXPECT_EQ(found.compatibility.free_components, 0);
        EXPECT_LE(found.report.residual, is_direct ? 1e-14 : 1e-10);
    }
}

TEST(ConstrainedSystem, refuses_sizes_that_do_not_fit) {
    EXPECT_REFUSED(ConstrainedSolver(system_of(paths({3}), {true, false}), "auto"), "3 rows",
                   "3 columns", "2 flags", "3 flags", "3 weights");
    ConstrainedSolver solver(system_of(paths({3}), {true, false, false}), "auto");
    EXPECT_REFUSED(solver.solve(Vector::Zero(2), Vector::Zero(3)), "right-hand side", "2 entries",
                   "fixed values", "3", "3");
}

TEST(ConstrainedSystem, has_signed_weights_with_a_positive_sum) {
    auto system = system_of(paths({3}), {false, false, false});
    system.weights = vector({2, -1, 2});
    const Vector u =
        ConstrainedSolver(system, "auto").solve(vector({1, 1, -2}), vector({0, 0, 0})).values;
    EXPECT_NEAR(system.weights.dot(u), 0, 1e-14);
    system.weights = vector({1, -3, 1});
    EXPECT_REFUSED(ConstrainedSolver(system, "auto"), "weights", "positive sum");
}

} // namespace polydec::test::in_constrained_system
