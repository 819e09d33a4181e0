// SPDX-License-Identifier: MIT
#include "dec/merging/lift.h"
#include "tests/support/test.h"

namespace polydec::test::in_golden_calculus {

class GoldenCalculus : public OverGoldenForms {
protected:
    void expect_cochain(const std::string& key, const Form& form, int k) const {
        const Vector w = on_merged_cells(mesh(), k, form);
        const auto& form_numbers = numbers().at(key);
        EXPECT_GOLDEN(form_numbers.at("norm"), w.norm()) << key;
        EXPECT_GOLDEN(form_numbers.at("abs_sum"), w.cwiseAbs().sum()) << key;
        if (form_numbers.contains("d_norm")) {
            EXPECT_GOLDEN(form_numbers.at("d_norm"), (derivative(mesh().P(), k) * w).norm()) << key;
        }
        EXPECT_GOLDEN(form_numbers.at("star_square"),
                      w.dot(star(mesh().volumes, k).diagonal().cwiseProduct(w)))
            << key;
    }

    void expect_lift(const std::string& key, const Vector& lifted) const {
        EXPECT_GOLDEN(numbers().at(key).at("norm"), lifted.norm()) << key;
        EXPECT_GOLDEN(numbers().at(key).at("abs_sum"), lifted.cwiseAbs().sum()) << key;
    }
};

TEST_P(GoldenCalculus, counts_and_betti_numbers) {
    EXPECT_EQ(numbers().at("counts"), sizes(mesh().P()));
    EXPECT_EQ(numbers().at("betti"), betti_numbers(mesh().P()));
    EXPECT_EQ(numbers().at("betti_relative"),
              betti_numbers(relative_to_boundary(mesh().P()).complex));
}

TEST_P(GoldenCalculus, integrals_of_the_test_forms) {
    expect_cochain("alpha", alpha, 1);
    expect_cochain("beta", beta, 1);
    expect_cochain("eta", eta, 2);
}

TEST_P(GoldenCalculus, lifts_of_the_test_forms) {
    const auto S = commuting_lift(mesh().merging(), mesh().geometry());
    const Vector a = on_merged_cells(mesh(), 1, alpha);
    expect_lift("lift1_alpha", S[1] * a);
    expect_lift("lift2_eta", S[2] * on_merged_cells(mesh(), 2, eta));
    expect_lift("lift2_d_alpha", S[2] * (derivative(mesh().P(), 1) * a));
}

TEST_P(GoldenCalculus, stars_by_vertices) {
    for (int k = 0; k <= mesh().n(); ++k)
        if (const auto key = fmt::format("star{}", k); numbers().contains(key))
            expect_stars(numbers().at(key), mesh(), k);
}

POLYDEC_OVER_GOLDEN_FORMS(GoldenCalculus);

} // namespace polydec::test::in_golden_calculus
