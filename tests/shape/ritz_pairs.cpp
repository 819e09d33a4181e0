// SPDX-License-Identifier: MIT
#include "shape/ritz_pairs.h"

#include "tests/shape/known_shapes.h"

namespace polydec::test::in_ritz_pairs {

using Pencil = Eigen::GeneralizedSelfAdjointEigenSolver<DenseMatrix>;

template <class Check>
void for_all(const Check& check) {
    for (const auto& [name, shape] : small_shapes())
        for (const int level : {1, 2}) {
            SCOPED_TRACE(name + ", level " + std::to_string(level));
            const ConformingForm form(shape, level);
            const Pencil exact(DenseMatrix(*form.stiffness().matrix),
                               DenseMatrix(*form.mass().matrix));
            ASSERT_EQ(exact.info(), Eigen::Success);
            check(shape, form, exact);
        }
}

TEST(RayleighRitzBounds, of_any_vectors_are_not_below_eigenvalues) {
    for_all([](const Shape&, const ConformingForm& form, const Pencil& exact) {
        const Index count = std::min<Index>(6, form.family().size());
        const Vector values = exact.eigenvalues().head(count);
        const DenseMatrix vectors = exact.eigenvectors().leftCols(count);
        const double tiny = 1e-12 * values[count - 1];
        for (const double error : {0.0, 1e-3, 0.05, 0.3, 3.0}) {
            std::srand(5);
            const DenseMatrix mixing = DenseMatrix::Random(count, count);
            const DenseMatrix near = DenseMatrix::Identity(count, count) + error * mixing;
            const auto bounds = [&](const DenseMatrix& X) {
                return rayleigh_ritz_bounds(form.stiffness(), form.mass(), vectors * X);
            };
            EXPECT_GE((bounds(near) - values).minCoeff(), -tiny) << error;
            EXPECT_GE((bounds(orthonormal_columns(near)) - values).minCoeff(), -tiny) << error;
            if (error == 0)
                EXPECT_LE((bounds(near) - values).maxCoeff(), 1e3 * tiny);
        }
    });
}

TEST(RitzSolver, finds_the_smallest_eigenvalues) {
    for_all([](const Shape& shape, const ConformingForm& form, const Pencil& exact) {
        const Index zeros = zero_eigenvalues(shape);
        RitzSolver solver(shape, form, zeros, {});
        for (const Index count : {zeros + 1, Index{6}, form.family().size()}) {
            const auto [vectors, upper] = solver.smallest(std::min(count, form.family().size()));
            const Vector values = exact.eigenvalues().head(count);
            ASSERT_GE(upper.size(), count);
            ASSERT_EQ(upper.size(), vectors.cols());
            EXPECT_GE((upper.head(count) - values).minCoeff(), -1e-11 * values[count - 1]);
            EXPECT_LE((upper.head(count) - values).maxCoeff(), 1e-6 * values[count - 1]) << count;
        }
    });
}

} // namespace polydec::test::in_ritz_pairs
