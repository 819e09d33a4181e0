// SPDX-License-Identifier: MIT
#include "tests/backends/matrices.h"

namespace polydec::test::in_block_lanczos {

constexpr Index copies = 7;

/// Eigenvalues 10, 9 and 8 seven times each, all others spread over [0, 1].
Vector with_multiplets(Index size) {
    Vector values = Vector::LinSpaced(size, 0.0, 1.0);
    for (Index i = 0; i < copies; ++i)
        for (Index multiplet = 0; multiplet < 3; ++multiplet)
            values[(37 * (3 * i + multiplet)) % size] = 10.0 - multiplet;
    return values;
}

SymmetricOperator diagonal(const Vector& values) {
    return {static_cast<Index>(values.size()),
            [=](const Vector& x, Vector& y) { y = values.cwiseProduct(x); }};
}

EigenPairs largest(const SymmetricOperator& A, Index count, const EigenOptions& options = {}) {
    return make_eigen_solver("block-lanczos")->largest(A, count, options);
}

Index number_near(const Vector& values, double value) {
    return static_cast<Index>(((values.array() - value).abs() < 1e-9).count());
}

TEST(BlockLanczos, finds_all_copies_of_sevenfold_eigenvalues_in_one_run) {
    const Vector values = with_multiplets(2000);
    const auto pairs =
        largest(diagonal(values), 3 * copies, {.krylov_dimension = 20 * copies, .max_restarts = 0});
    ASSERT_EQ(pairs.converged, 3 * copies);
    for (const double value : {10.0, 9.0, 8.0})
        EXPECT_EQ(number_near(pairs.values, value), copies);
    EXPECT_LE(orthonormality_defect(pairs.vectors), 1e-12);
}

/// The broken twin: so short a subspace leaves blocks of one vector, whose Krylov space holds one
/// direction of each eigenspace.
TEST(BlockLanczos, misses_copies_where_its_blocks_are_single_vectors) {
    const Vector values = with_multiplets(2000);
    const auto pairs = largest(diagonal(values), 3 * copies,
                               {.krylov_dimension = 3 * copies + 2, .max_restarts = 0});
    EXPECT_GE(number_near(pairs.values, 10.0), 1);
    EXPECT_LT(number_near(pairs.values, 10.0), copies);
}

SymmetricOperator by_columns(const SparseMatrix& A) {
    return {static_cast<Index>(A.rows()), [&](const Vector& x, Vector& y) { y = A * x; },
            [&](const DenseMatrix& X, DenseMatrix& Y) { Y = A * X; }};
}

TEST(BlockLanczos, keeps_columns_orthonormal_through_restarts) {
    const auto A = grid_laplacian(30);
    const auto values = grid_eigenvalues(30, 2);
    const Vector exact = Eigen::Map<const Vector>(values.data(), 900).reverse();
    for (const Index dimension : {16, 20, 30, 60, 200}) {
        const auto pairs = largest(by_columns(A), 10, {.krylov_dimension = dimension});
        ASSERT_EQ(pairs.converged, 10) << dimension;
        EXPECT_LE(orthonormality_defect(pairs.vectors), 1e-12) << dimension;
        EXPECT_WITHIN(pairs.values, exact.head(10), 1e-12) << dimension;
        const DenseMatrix residuals = A * pairs.vectors - pairs.vectors * pairs.values.asDiagonal();
        EXPECT_LE(residuals.colwise().norm().maxCoeff(), 1.01e-10 * exact[0]) << dimension;
    }
}

TEST(BlockLanczos, applies_the_operator_to_eight_columns_at_once) {
    const auto A = grid_laplacian(30);
    Index columns = 0, calls = 0;
    auto counted = by_columns(A);
    counted.apply = [](const Vector&, Vector&) { throw InvalidInput("one by one"); };
    counted.apply_to_columns = [&](const DenseMatrix& X, DenseMatrix& Y) {
        Y = A * X;
        ++calls;
        columns += static_cast<Index>(X.cols());
    };
    const auto together = largest(counted, 10);
    EXPECT_EQ(columns, 8 * calls);
    EXPECT_EQ(together.operations, columns);

    auto one_by_one = by_columns(A);
    one_by_one.apply_to_columns = {};
    const auto apart = largest(one_by_one, 10);
    EXPECT_LE((apart.values - together.values).norm(), 1e-12);
}

TEST(BlockLanczos, refuses_columns_that_are_no_numbers_and_lets_errors_pass) {
    SymmetricOperator bad{200, [](const Vector& x, Vector& y) { y = x; }};
    bad.apply_to_columns = [](const DenseMatrix& X, DenseMatrix& Y) { Y = X * std::nan(""); };
    EXPECT_THROW(largest(bad, 3), SolverFailure);
    bad.apply_to_columns = [](const DenseMatrix& X, DenseMatrix& Y) { Y = X.leftCols(1); };
    EXPECT_THROW(largest(bad, 3), SolverFailure);
    bad.apply_to_columns = [](const DenseMatrix&, DenseMatrix&) { throw InvalidInput("no"); };
    EXPECT_EQ(message_of<InvalidInput>([&] { largest(bad, 3); }), "no");
}

} // namespace polydec::test::in_block_lanczos
