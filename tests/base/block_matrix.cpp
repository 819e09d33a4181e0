// SPDX-License-Identifier: MIT
#include "base/block_matrix.h"

#include "tests/support/test.h"

namespace polydec::test::in_block_matrix {

/// A matrix with about half of its entries 0.
SparseMatrix half_full(Index rows, Index cols, unsigned seed) {
    Vector numbers(rows * cols);
    Noise(seed).fill(numbers);
    return DenseMatrix(numbers.cwiseMax(0).reshaped(rows, cols)).sparseView();
}

DenseMatrix dense(const SparseMatrix& A, const SparseMatrix& B, const SparseMatrix& D) {
    DenseMatrix result(A.rows() + D.rows(), A.rows() + D.rows());
    result.topLeftCorner(A.rows(), A.rows()) = DenseMatrix(A);
    result.topRightCorner(A.rows(), D.rows()) = DenseMatrix(B).transpose();
    result.bottomLeftCorner(D.rows(), A.rows()) = DenseMatrix(B);
    result.bottomRightCorner(D.rows(), D.rows()) = DenseMatrix(D);
    return result;
}

TEST(block_matrix, has_its_blocks_with_the_entries_of_rows_in_order) {
    for (const Index m : {0, 1, 7})
        for (const Index n : {0, 1, 5}) {
            if (m + n == 0)
                continue;
            const SparseMatrix A = half_full(m, m, 1), B = half_full(n, m, 2),
                               D = half_full(n, n, 3), M = block_matrix(A, B, D);
            EXPECT_TRUE(M.isCompressed());
            EXPECT_EQ(M.nonZeros(), A.nonZeros() + 2 * B.nonZeros() + D.nonZeros());
            EXPECT_EQ(DenseMatrix(M), dense(A, B, D));
            for (Index row = 0; row < M.rows(); ++row)
                EXPECT_TRUE(std::is_sorted(M.innerIndexPtr() + M.outerIndexPtr()[row],
                                           M.innerIndexPtr() + M.outerIndexPtr()[row + 1]));
        }
    const SparseMatrix A = half_full(4, 4, 1), B = half_full(3, 4, 2), D = half_full(3, 3, 3);
    EXPECT_NE(DenseMatrix(block_matrix(A, -B, D)), dense(A, B, D));
}

} // namespace polydec::test::in_block_matrix
