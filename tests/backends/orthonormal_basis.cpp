// SPDX-License-Identifier: MIT
#include "backends/eigen/orthonormal_basis.h"

#include "tests/backends/matrices.h"

namespace polydec::test::in_orthonormal_basis {

DenseMatrix all_columns(const OrthonormalBasis& basis) {
    return basis.columns(0, basis.size());
}

DenseMatrix random_of_rank(Index rows, Index columns, Index rank, unsigned seed) {
    return random_matrix(rows, rank, seed) * random_matrix(rank, columns, seed + 1);
}

TEST(OrthonormalBasis, stays_orthonormal_and_returns_the_factor_of_what_is_new_at_every_rank) {
    for (const double scale : {1e-40, 1.0, 1e40})
        for (Index rank = 0; rank <= 6; ++rank) {
            OrthonormalBasis basis(300, 30);
            for (unsigned block = 0; block < 4; ++block) {
                SCOPED_TRACE(testing::Message() << scale << ", rank " << rank << ", " << block);
                const DenseMatrix before = all_columns(basis);
                const DenseMatrix W =
                    scale * (rank == 0 ? DenseMatrix(DenseMatrix::Zero(300, 6))
                                       : random_of_rank(300, 6, rank, 10 * block + 1));
                DenseMatrix work = W;
                const DenseMatrix R = basis.append(work, 1e-14 * scale);
                EXPECT_LE(orthonormality_defect(all_columns(basis)), 1e-14);
                const DenseMatrix outside = W - before * (before.transpose() * W);
                EXPECT_LE((outside - basis.columns(6 * block, 6) * R).norm(),
                          1e-13 * (W.norm() + scale));
                Index zero_rows = 0;
                for (Index i = 0; i < 6; ++i)
                    zero_rows += R.row(i).isZero(0.0) ? 1 : 0;
                EXPECT_EQ(zero_rows, 6 - rank);
            }
        }
}

/// Columns that lie nearly in the span, where digits cancel.
DenseMatrix nearly_inside(const DenseMatrix& V) {
    return V * random_matrix(static_cast<Index>(V.cols()), 5, 8) +
           1e-10 * random_matrix(static_cast<Index>(V.rows()), 5, 9);
}

TEST(OrthonormalBasis, takes_columns_that_lie_nearly_in_its_span) {
    OrthonormalBasis basis(400, 25);
    DenseMatrix first = random_matrix(400, 20, 3);
    basis.append(first, 0.0);
    DenseMatrix W = nearly_inside(all_columns(basis));
    const DenseMatrix R = basis.append(W, 1e-14);
    EXPECT_LE(orthonormality_defect(all_columns(basis)), 1e-14);
    EXPECT_GT(R.diagonal().minCoeff(), 1e-10);
}

/// The broken twin: one projection leaves those columns far from orthogonal.
TEST(OrthonormalBasis, would_fail_with_a_single_projection) {
    OrthonormalBasis basis(400, 20);
    DenseMatrix first = random_matrix(400, 20, 3);
    basis.append(first, 0.0);
    const DenseMatrix V = all_columns(basis);
    DenseMatrix W = nearly_inside(V);
    W -= V * (V.transpose() * W).eval();
    W.colwise().normalize();
    EXPECT_GT((V.transpose() * W).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(OrthonormalBasis, fills_the_whole_space) {
    OrthonormalBasis basis(24, 24);
    for (int block = 0; block < 3; ++block) {
        DenseMatrix zero = DenseMatrix::Zero(24, 8);
        EXPECT_TRUE(basis.append(zero, 0.0).isZero(0.0));
    }
    EXPECT_LE(orthonormality_defect(all_columns(basis)), 1e-14);
}

TEST(OrthonormalBasis, combines_its_first_columns_and_keeps_the_others) {
    OrthonormalBasis basis(5000, 20);
    DenseMatrix W = random_matrix(5000, 20, 5);
    basis.append(W, 0.0);
    const DenseMatrix V = all_columns(basis);
    OrthonormalBasis rotation(16, 6);
    DenseMatrix S = random_matrix(16, 6, 6);
    rotation.append(S, 0.0);
    basis.combine(rotation.columns(0, 6));
    ASSERT_EQ(basis.size(), 10);
    EXPECT_LE((basis.columns(0, 6) - V.leftCols(16) * rotation.columns(0, 6)).norm(), 1e-13);
    EXPECT_EQ(DenseMatrix(basis.columns(6, 4)), DenseMatrix(V.rightCols(4)));
}

TEST(OrthonormalBasis, refuses_what_has_no_room_or_is_no_number) {
    EXPECT_THROW(OrthonormalBasis(3, 4), InvalidInput);
    OrthonormalBasis basis(9, 4);
    DenseMatrix wide = DenseMatrix::Ones(9, 5);
    EXPECT_THROW(basis.append(wide, 0.0), InvalidInput);
    DenseMatrix high = DenseMatrix::Ones(8, 2);
    EXPECT_THROW(basis.append(high, 0.0), InvalidInput);
    DenseMatrix nan = DenseMatrix::Constant(9, 2, std::nan(""));
    EXPECT_THROW(basis.append(nan, 0.0), SolverFailure);
}

} // namespace polydec::test::in_orthonormal_basis
