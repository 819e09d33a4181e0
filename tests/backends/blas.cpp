// SPDX-License-Identifier: MIT
#include "backends/blas.h"

#include "tests/backends/matrices.h"

namespace polydec::test::in_blas {

TEST(blas, products_are_those_of_eigen_also_of_blocks_and_of_nothing) {
    has_linear_solver("cholmod"); // brings a BLAS where it is there
    const DenseMatrix A = random_matrix(40, 9, 1), B = random_matrix(9, 5, 2);
    const auto part = A.block(3, 2, 30, 6);
    for (const Index inner : {6, 1, 0}) {
        DenseMatrix C = random_matrix(30, 5, 3);
        const DenseMatrix expected = 0.5 * C - 2 * part.leftCols(inner) * B.topRows(inner);
        add_product(-2, part.leftCols(inner), B.topRows(inner), 0.5, C);
        EXPECT_LE((C - expected).norm(), 1e-13) << inner;
    }
    EXPECT_LE(
        (transposed_product(part, A.middleRows(3, 30)) - part.transpose() * A.middleRows(3, 30))
            .norm(),
        1e-13);
    EXPECT_EQ(transposed_product(part.leftCols(0), part).size(), 0);
}

TEST(blas, eigenpairs_of_symmetric_matrices_are_all_there_ascending_and_orthonormal) {
    has_linear_solver("cholmod");
    for (const Index n : {0, 1, 7, 150, 220}) {
        const DenseMatrix given = random_matrix(n, n, 4);
        const DenseMatrix A = given + given.transpose();
        DenseMatrix lower = A; // the rest is not read
        lower.triangularView<Eigen::StrictlyUpper>().setConstant(1e3);
        const auto [values, vectors] = symmetric_pairs(lower, "an engine");
        ASSERT_EQ(values.size(), n);
        EXPECT_TRUE(std::is_sorted(values.begin(), values.end()));
        EXPECT_LE((A * vectors - vectors * values.asDiagonal()).norm(), 1e-12 * n);
        EXPECT_LE((vectors.transpose() * vectors - DenseMatrix::Identity(n, n)).norm(), 1e-13 * n);
    }
}

TEST(blas, what_is_not_kept_need_not_be_a_number) {
    const DenseMatrix A = random_matrix(20, 4, 1), B = random_matrix(4, 3, 2);
    DenseMatrix C = DenseMatrix::Constant(20, 3, std::numeric_limits<double>::quiet_NaN());
    add_product(1, A, B, 0, C);
    EXPECT_LE((C - A * B).norm(), 1e-13);
}

TEST(blas, what_the_environment_says_of_it_stays) {
    prepare_blas();
    EXPECT_NE(std::getenv("OPENBLAS_NUM_THREADS"), nullptr);
    setenv("OPENBLAS_CORETYPE", "Nehalem", 1);
    prepare_blas();
    EXPECT_STREQ(std::getenv("OPENBLAS_CORETYPE"), "Nehalem");
    unsetenv("OPENBLAS_CORETYPE");
    prepare_blas();
}

TEST(blas, one_that_is_loaded_says_what_it_is) {
    has_linear_solver("cholmod");
    const auto blas = loaded_blas();
    if (!blas)
        return; // there is none, or another
    EXPECT_EQ(blas->name.find("OpenBLAS "), 0u) << blas->name;
    EXPECT_FALSE(blas->kernels.empty());
    EXPECT_GE(blas->threads, 1);
    EXPECT_TRUE(blas->integer_bits == 32 || blas->integer_bits == 64);
}

} // namespace polydec::test::in_blas
