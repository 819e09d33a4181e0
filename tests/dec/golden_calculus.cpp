// SPDX-License-Identifier: MIT
#include "dec/merging/lift.h"
#include "tests/dec/discretized.h"

namespace polydec::test::in_golden_calculus {

void expect_sizes(const Json& expected, const Vector& values, const std::string& key) {
    EXPECT_GOLDEN(expected.at("norm"), values.norm()) << key;
    EXPECT_GOLDEN(expected.at("abs_sum"), values.cwiseAbs().sum()) << key;
}

class GoldenCalculus : public OverGoldenForms {
protected:
    Cochain form(const Form& smooth, int k) const {
        return {Side::primal, k, on_merged_cells(mesh(), k, smooth)};
    }

    /// The function sin(1 + i) at vertex i.
    Cochain function() const {
        Vector values(mesh().P().size(0));
        for (Index v = 0; v < values.size(); ++v)
            values[v] = std::sin(1.0 + mesh().K().vertex_number(v));
        return {Side::primal, 0, values};
    }

    void expect_cochain(const std::string& key, const Form& smooth, int k) const {
        const Vector w = form(smooth, k).values;
        const auto& expected = numbers().at(key);
        expect_sizes(expected, w, key);
        if (expected.contains("d_norm")) {
            EXPECT_GOLDEN(expected.at("d_norm"), (derivative(mesh().P(), k) * w).norm()) << key;
        }
        EXPECT_GOLDEN(expected.at("star_square"),
                      w.dot(star(mesh().volumes, k).diagonal().cwiseProduct(w)))
            << key;
    }

    void expect_product(const std::string& key, const Cochain& a, const Cochain& b) const {
        const Vector found = wedge(discretized(stem(GetParam())), a, b).values;
        const auto& expected = numbers().at(key);
        expect_sizes(expected, found, key);
        if (expected.contains("total")) {
            EXPECT_GOLDEN(expected.at("total"), found.sum()) << key;
        }
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
    const Vector a = form(alpha, 1).values;
    expect_sizes(numbers().at("lift1_alpha"), S[1] * a, "alpha");
    expect_sizes(numbers().at("lift2_eta"), S[2] * form(eta, 2).values, "eta");
    expect_sizes(numbers().at("lift2_d_alpha"), S[2] * (derivative(mesh().P(), 1) * a), "d alpha");
}

TEST_P(GoldenCalculus, products_of_the_test_forms) {
    const auto a = form(alpha, 1), b = form(beta, 1), e = form(eta, 2);
    expect_product("wedge_alpha_beta", a, b);
    expect_product("wedge_f_alpha", function(), a);
    if (mesh().n() >= 3)
        expect_product("wedge_alpha_eta", a, e);
    if (mesh().n() >= 4)
        expect_product("wedge_eta_eta", e, e);
}

TEST_P(GoldenCalculus, stars_by_vertices) {
    for (int k = 0; k <= mesh().n(); ++k)
        if (const auto key = fmt::format("star{}", k); numbers().contains(key))
            expect_stars(numbers().at(key), mesh(), k);
}

POLYDEC_OVER_GOLDEN_FORMS(GoldenCalculus);

} // namespace polydec::test::in_golden_calculus
