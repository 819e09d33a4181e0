// SPDX-License-Identifier: MIT
#include "shape/lehmann_bounds.h"

#include "shape/forms.h"
#include "tests/shape/known_shapes.h"

namespace polydec::test::in_lehmann_bounds {

constexpr Index below = 6;

/// A number with as many eigenvalues of the form below it as wanted, or more, and that many.
std::pair<double, Index> counted(FamilyCounter& counter) {
    double s = 1e-3;
    std::optional<Index> count;
    do
        count = counter.at(s *= 1.07);
    while (!count || *count < below);
    return {s, *count};
}

/// Eigenvectors of Q(t) relative to Q(s) - Q(t), those of the smallest values.
DenseMatrix eigenvectors(const FormFamily& family, double s, double t, Index count) {
    const DenseMatrix at_t = *family.at(t).matrix,
                      drop = *family.at(s).matrix - *family.at(t).matrix;
    const Eigen::GeneralizedSelfAdjointEigenSolver<DenseMatrix> pencil(at_t, drop);
    EXPECT_EQ(pencil.info(), Eigen::Success);
    return pencil.eigenvectors().leftCols(count);
}

template <class Check>
void for_all(const Check& check) {
    for (const auto& [name, shape] : small_shapes())
        for (const int level : {1, 2}) {
            SCOPED_TRACE(name + ", level " + std::to_string(level));
            const FormFamily family = lower_form(shape, level);
            FamilyCounter counter(family, "auto");
            const auto [t, count] = counted(counter);
            check(family, counter, t, count);
        }
}

/// s/t at which eigenvalues are counted.
constexpr std::array places{0.02, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 0.95, 0.99};

TEST(LehmannBounds, of_any_vectors_are_not_below_counts) {
    for_all([](const FormFamily& family, FamilyCounter& counter, double t, Index count) {
        const DenseMatrix exact = eigenvectors(family, t / 2, t, count);
        int proved = 0;
        for (const double error : {0.0, 0.03, 0.3, 100.0}) {
            std::srand(7);
            const DenseMatrix X = exact + error * exact.norm() / exact.size() *
                                              DenseMatrix::Random(exact.rows(), count);
            ASSERT_EQ(counter.at(t), count);
            const LehmannBounds bounds(counter, t / 2, X);
            for (const double place : places)
                if (const auto ratios = bounds.ratios(place * t)) {
                    ++proved;
                    EXPECT_GE((ratios->most.array() >= 1).count(), counter.at(place * t).value())
                        << error << " " << place;
                    EXPECT_GE((ratios->most - ratios->least).minCoeff(),
                              -1e-8 * ratios->most.maxCoeff());
                }
        }
        EXPECT_GE(proved, 12);
    });
}

/// Eigenvectors lose nothing, without eliminated unknowns of cells: those have their share in
/// eigenvectors.
TEST(LehmannBounds, of_eigenvectors_are_counts) {
    for_all([](const FormFamily& family, FamilyCounter& counter, double t, Index count) {
        const LehmannBounds bounds(counter, 0.9 * t, eigenvectors(family, 0.9 * t, t, count));
        const auto ratios = bounds.ratios(0.9 * t);
        ASSERT_TRUE(ratios);
        if (family.cell(0).size() == 0)
            EXPECT_LE((ratios->most - ratios->least).maxCoeff(), 1e-6 * ratios->most.maxCoeff());
        EXPECT_EQ((ratios->most.array() >= 1).count(), counter.at(0.9 * t));
    });
}

} // namespace polydec::test::in_lehmann_bounds
