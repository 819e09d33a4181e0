// SPDX-License-Identifier: MIT
#include "tests/backends/matrices.h"

#include <rapidcheck/gtest.h>

namespace polydec::test::in_eigen_contract {

SymmetricOperator by_matrix(const SparseMatrix& A) {
    return {static_cast<Index>(A.rows()), [A](const Vector& x, Vector& y) { y = A * x; }};
}

/// Whether these are eigenpairs of A: descending, orthonormal, with small residuals.
bool are_eigenpairs(const SparseMatrix& A, const EigenPairs& pairs) {
    const auto count = static_cast<Eigen::Index>(pairs.converged);
    if (pairs.values.size() != count || pairs.vectors.cols() != count ||
        pairs.vectors.rows() != A.rows() || !pairs.values.allFinite() || !pairs.vectors.allFinite())
        return false;
    for (Eigen::Index i = 0; i + 1 < count; ++i)
        if (pairs.values[i] < pairs.values[i + 1])
            return false;
    const double scale = DenseMatrix(A).norm();
    const DenseMatrix gram = pairs.vectors.transpose() * pairs.vectors;
    const DenseMatrix R = A * pairs.vectors - pairs.vectors * pairs.values.asDiagonal();
    return (gram - DenseMatrix::Identity(count, count)).norm() <= 1e-9 * (1.0 + count) &&
           R.norm() <= 1e-8 * scale;
}

class EigenContract : public testing::TestWithParam<std::string> {
protected:
    EigenPairs largest(const SparseMatrix& A, Index count, const EigenOptions& options = {}) const {
        return make_eigen_solver(GetParam())->largest(by_matrix(A), count, options);
    }
};

TEST_P(EigenContract, largest_eigenvalues_agree_with_dense_ones_at_every_size_and_count) {
    for (const Index size : {1, 2, 3, 12, 39, 41, 60}) {
        const auto A = sparse(random_symmetric(size, 100u + static_cast<unsigned>(size)));
        const Vector expected = dense_eigenvalues(A).reverse();
        for (const Index count : {Index{0}, Index{1}, size / 3, size / 2, size - 1, size}) {
            const auto pairs = largest(A, count);
            ASSERT_EQ(pairs.converged, count) << "size " << size;
            EXPECT_TRUE(are_eigenpairs(A, pairs)) << "size " << size << ", count " << count;
            EXPECT_LE((pairs.values - expected.head(count)).norm(), 1e-9 * (1.0 + expected.norm()));
        }
    }
}

TEST_P(EigenContract, algebraically_largest_means_so_for_negative_operators) {
    const SparseMatrix A = -grid_laplacian(12);
    const auto pairs = largest(A, 1);
    ASSERT_EQ(pairs.converged, 1);
    EXPECT_NEAR(pairs.values[0], dense_eigenvalues(A).maxCoeff(), 1e-9);
}

TEST_P(EigenContract, multiplets_give_eigenpairs_and_never_nan) {
    const auto A = grid_laplacian(12);
    const auto pairs = largest(A, 12);
    EXPECT_TRUE(are_eigenpairs(A, pairs));
    EXPECT_GE(pairs.converged, 6);
    EXPECT_NEAR(pairs.values[0], dense_eigenvalues(A).maxCoeff(), 1e-9);
}

TEST_P(EigenContract, the_check_of_the_tests_catches_wrong_pairs) {
    const auto A = grid_laplacian(7);
    auto pairs = largest(A, 4);
    ASSERT_TRUE(are_eigenpairs(A, pairs));
    auto wrong_value = pairs;
    wrong_value.values[0] *= 1.0 + 1e-5;
    EXPECT_FALSE(are_eigenpairs(A, wrong_value));
    auto wrong_vector = pairs;
    wrong_vector.vectors.col(1) = pairs.vectors.col(0);
    EXPECT_FALSE(are_eigenpairs(A, wrong_vector));
    auto wrong_order = pairs;
    wrong_order.values.reverseInPlace();
    wrong_order.vectors = pairs.vectors.rowwise().reverse().eval();
    EXPECT_FALSE(are_eigenpairs(A, wrong_order));
}

// Krylov spaces of these operators end after one or two steps.
TEST_P(EigenContract, invariant_subspaces_do_not_break_it) {
    const Index size = 80;
    SparseMatrix zero(size, size);
    SparseMatrix identity(size, size);
    identity.setIdentity();
    SparseMatrix corner(size, size);
    corner.insert(0, 0) = 5.0;
    SparseMatrix projection = identity;
    projection.coeffRef(3, 3) = 0.0;
    SparseMatrix split = identity;
    for (Index i = 0; i < size / 2; ++i)
        split.coeffRef(i, i) = -1.0;

    for (const auto& [A, expected] :
         {std::pair{zero, 0.0}, std::pair{identity, 1.0}, std::pair{corner, 5.0},
          std::pair{projection, 1.0}, std::pair{split, 1.0}}) {
        for (const Index count : {1, 3, 30}) {
            const auto pairs = largest(A, count);
            EXPECT_TRUE(are_eigenpairs(A, pairs)) << expected << ", " << count;
            ASSERT_GE(pairs.converged, 1) << expected << ", " << count;
            EXPECT_NEAR(pairs.values[0], expected, 1e-9);
        }
    }
}

TEST_P(EigenContract, start_vectors_in_the_kernel_or_an_eigenspace_are_taken) {
    SparseMatrix A = grid_laplacian(9);
    for (Index i = 0; i < 81; ++i) {
        A.coeffRef(i, 0) = 0.0;
        A.coeffRef(0, i) = 0.0;
    }
    EigenOptions options;
    options.start = Vector::Unit(81, 0);
    const auto pairs = largest(A, 3, options);
    EXPECT_TRUE(are_eigenpairs(A, pairs));
    EXPECT_NEAR(pairs.values[0], dense_eigenvalues(A).maxCoeff(), 1e-9);
}

TEST_P(EigenContract, scale_does_not_matter) {
    const auto A = grid_laplacian(9);
    const auto expected = largest(A, 4);
    for (const double scale : {1e-40, 1e-8, 1e8, 1e40}) {
        const auto pairs = largest(scale * A, 4);
        ASSERT_EQ(pairs.converged, expected.converged) << scale;
        EXPECT_LE((pairs.values / scale - expected.values).norm(), 1e-9) << scale;
    }
}

TEST_P(EigenContract, an_iteration_limit_is_no_failure) {
    const auto pairs = largest(grid_laplacian(30), 10, {.krylov_dimension = 12, .max_restarts = 2});
    EXPECT_LT(pairs.converged, 10);
    EXPECT_EQ(pairs.values.size(), pairs.converged);
    EXPECT_EQ(pairs.vectors.cols(), pairs.converged);
    EXPECT_EQ(pairs.vectors.rows(), 900);
    EXPECT_GT(pairs.operations, 0);
}

TEST_P(EigenContract, the_same_question_has_the_same_answer) {
    const auto A = grid_laplacian(12);
    const auto first = largest(A, 5);
    const auto second = largest(A, 5);
    EXPECT_EQ(first.values, second.values);
    EXPECT_EQ(first.vectors, second.vectors);
}

TEST_P(EigenContract, impossible_questions_are_refused) {
    const auto A = grid_laplacian(3);
    const auto solver = make_eigen_solver(GetParam());
    EXPECT_REFUSED(largest(A, 10), GetParam(), "10 eigenpairs", "9");
    EXPECT_THROW(largest(A, -1), InvalidInput);
    EXPECT_THROW(largest(A, 1, {.tolerance = 0.0}), InvalidInput);
    EXPECT_THROW(largest(A, 1, {.krylov_dimension = -1}), InvalidInput);
    EXPECT_THROW(largest(A, 1, {.start = Vector::Zero(9)}), InvalidInput);
    EXPECT_THROW(largest(A, 1, {.start = Vector::Ones(8)}), InvalidInput);
    EXPECT_THROW(solver->largest({4, {}}, 1), InvalidInput);
    EXPECT_EQ(largest(SparseMatrix(0, 0), 0).converged, 0);
}

TEST_P(EigenContract, operators_that_give_nan_are_refused) {
    const auto solver = make_eigen_solver(GetParam());
    for (const Index size : {5, 100}) {
        const SymmetricOperator nan{size, [](const Vector& x, Vector& y) { y = x * std::nan(""); }};
        EXPECT_THROW(solver->largest(nan, 2), SolverFailure);
        const SymmetricOperator short_one{size, [](const Vector&, Vector& y) { y.resize(1); }};
        EXPECT_THROW(solver->largest(short_one, 2), SolverFailure);
    }
}

TEST_P(EigenContract, errors_of_the_operator_pass_through) {
    const auto solver = make_eigen_solver(GetParam());
    const SymmetricOperator refusing{100, [](const Vector&, Vector&) { throw InvalidInput("no"); }};
    EXPECT_EQ(message_of<InvalidInput>([&] { solver->largest(refusing, 2); }), "no");
}

INSTANTIATE_TEST_SUITE_P(engines, EigenContract, testing::ValuesIn(eigen_engine_names()),
                         [](const auto& test) { return test_name(test.param); });

RC_GTEST_PROP(eigen_solver, diagonal_operators_with_repeated_values_give_true_pairs, ()) {
    const Index size = *rc::gen::inRange(1, 90);
    SparseMatrix A(size, size);
    for (Index i = 0; i < size; ++i)
        A.insert(i, i) = *rc::gen::element(0.0, 1.0, 1.0, 2.0, -3.0, 1e-8);
    const Index count = *rc::gen::inRange(Index{0}, static_cast<Index>(size + 1));
    for (const auto& engine : eigen_engine_names())
        RC_ASSERT(are_eigenpairs(A, make_eigen_solver(engine)->largest(by_matrix(A), count)));
}

} // namespace polydec::test::in_eigen_contract
