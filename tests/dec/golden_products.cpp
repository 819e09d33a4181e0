// SPDX-License-Identifier: MIT
#include "tests/dec/discretized.h"

namespace polydec::test::in_golden_products {

class GoldenProducts : public OverGoldenForms {
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

    void expect_product(const std::string& key, const Cochain& a, const Cochain& b) const {
        const auto& expected = golden_calculus().at(GetParam()).at(key);
        const Vector found = wedge(discretized(stem(GetParam())), a, b).values;
        EXPECT_GOLDEN(expected.at("norm"), found.norm()) << key;
        EXPECT_GOLDEN(expected.at("abs_sum"), found.cwiseAbs().sum()) << key;
        if (expected.contains("total")) {
            EXPECT_GOLDEN(expected.at("total"), found.sum()) << key;
        }
    }
};

TEST_P(GoldenProducts, of_the_test_forms) {
    const auto a = form(alpha, 1), b = form(beta, 1), e = form(eta, 2);
    expect_product("wedge_alpha_beta", a, b);
    expect_product("wedge_f_alpha", function(), a);
    if (mesh().n() >= 3)
        expect_product("wedge_alpha_eta", a, e);
    if (mesh().n() >= 4)
        expect_product("wedge_eta_eta", e, e);
}

POLYDEC_OVER_GOLDEN_FORMS(GoldenProducts);

} // namespace polydec::test::in_golden_products
