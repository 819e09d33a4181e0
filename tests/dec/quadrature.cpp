// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_quadrature {

/// Largest error of the rule among the monomials of this total degree in barycentric coordinates,
/// which span all polynomials up to it. Their means are k! prod a_i! / (k + sum a_i)!.
double largest_error(const SimplexQuadrature& rule, int degree) {
    const auto k = static_cast<int>(rule.points.cols()) - 1;
    double worst = 0;
    const auto visit = [&](const auto& self, int place, int rest, double mean,
                           const Vector& values) -> void {
        if (place == k) {
            const Vector last = values.array() * rule.points.col(k).array().pow(rest);
            const double exact = mean * std::tgamma(rest + 1.0);
            worst = std::max(worst, std::abs(rule.weights.dot(last) - exact));
            return;
        }
        for (int power = 0; power <= rest; ++power)
            self(self, place + 1, rest - power, mean * std::tgamma(power + 1.0),
                 values.array() * rule.points.col(place).array().pow(power));
    };
    visit(visit, 0, degree, std::tgamma(k + 1.0) / std::tgamma(k + degree + 1.0),
          Vector::Ones(rule.weights.size()));
    return worst;
}

TEST(Quadrature, is_exact_up_to_its_degree_on_simplices_of_every_dimension) {
    for (int k = 0; k <= 6; ++k)
        for (int degree = 1; degree <= 9; ++degree)
            EXPECT_LE(largest_error(grundmann_moeller(k, degree), degree), 1e-13)
                << "k = " << k << ", degree " << degree;
}

TEST(Quadrature, has_weights_of_sum_1_at_points_of_the_simplex) {
    for (int k = 0; k <= 6; ++k)
        for (int degree = 0; degree <= 9; ++degree) {
            const auto rule = grundmann_moeller(k, degree);
            EXPECT_NEAR(rule.weights.sum(), 1, 1e-13);
            EXPECT_GT(rule.points.minCoeff(), 0);
            EXPECT_LE((rule.points.rowwise().sum().array() - 1).abs().maxCoeff(), 1e-15);
        }
}

TEST(Quadrature, has_as_many_points_as_there_are_monomials) {
    EXPECT_EQ(grundmann_moeller(0, 5).weights.size(), 1);
    EXPECT_EQ(grundmann_moeller(1, 5).weights.size(), 6);
    EXPECT_EQ(grundmann_moeller(2, 5).weights.size(), 10);
    EXPECT_EQ(grundmann_moeller(3, 4).weights.size(), 15) << "rounded up to degree 5";
}

TEST(QuadratureBroken, beyond_its_degree_is_not_exact) {
    for (int k = 1; k <= 4; ++k)
        for (const int degree : {1, 3, 5}) {
            const auto rule = grundmann_moeller(k, degree);
            EXPECT_GT(largest_error(rule, degree + 1), 1e-7) << "k = " << k << ", " << degree;
            EXPECT_GT(largest_error(rule, degree + 2), 1e-7) << "k = " << k << ", " << degree;
        }
}

TEST(Quadrature, of_high_degree_integrates_constants_or_is_refused) {
    EXPECT_NEAR(grundmann_moeller(1, 41).weights.sum(), 1, 1e-8);
    EXPECT_REFUSED(grundmann_moeller(1, 42), "degree 42", "dimension 1", "at most 41");
    for (int k = 1; k <= 4; ++k) {
        EXPECT_NEAR(grundmann_moeller(k, 37).weights.sum(), 1, 1e-8) << k;
        for (const int degree : {200, 1'000'000})
            EXPECT_REFUSED(grundmann_moeller(k, degree), "degree " + std::to_string(degree),
                           "weights cancel", "at most");
    }
}

TEST(Quadrature, refuses_negative_numbers) {
    EXPECT_REFUSED(grundmann_moeller(-1, 3), "degree 3", "dimension -1", "at least 0");
    EXPECT_THROW(grundmann_moeller(2, -1), InvalidInput);
}

} // namespace polydec::test::in_quadrature
