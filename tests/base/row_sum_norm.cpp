// SPDX-License-Identifier: MIT
#include "base/row_sum_norm.h"

#include "tests/support/test.h"

namespace polydec::test::in_row_sum_norm {

SparseMatrix example(std::uint32_t seed) {
    DenseMatrix A(5, 7);
    Noise(seed).fill(A.reshaped());
    return A.sparseView();
}

/// |A x| in the maximum norm, where x has the signs of a row: 1 is the size of x.
double reached_by_signs(const SparseMatrix& A) {
    double most = 0;
    for (Eigen::Index row = 0; row < A.rows(); ++row) {
        const Vector signs = DenseMatrix(A).row(row).transpose().array().sign();
        most = std::max(most, (A * signs).lpNorm<Eigen::Infinity>());
    }
    return most;
}

TEST(row_sum_norm, is_the_most_that_a_vector_of_size_one_grows) {
    EXPECT_EQ(row_sum_norm(SparseMatrix(3, 3)), 0.0);
    for (const std::uint32_t seed : {1U, 2U, 3U}) {
        const auto A = example(seed);
        EXPECT_DOUBLE_EQ(row_sum_norm(A), reached_by_signs(A));
        Vector x(7);
        Noise(seed + 10).fill(x);
        EXPECT_LE((A * x).lpNorm<Eigen::Infinity>(), row_sum_norm(A) * x.lpNorm<Eigen::Infinity>());
    }
}

TEST(row_sum_norm, of_the_transposed_matrix_is_another_one) {
    EXPECT_NE(row_sum_norm(example(1)), row_sum_norm(example(1).transpose()));
}

} // namespace polydec::test::in_row_sum_norm
