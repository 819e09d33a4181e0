// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_golden_hodge {

class GoldenHodge : public OverGoldenForms {
protected:
    /// alpha or eta, by degree.
    Vector form(int k) const { return on_merged_cells(mesh(), k, k == 1 ? alpha : eta); }

    void expect_parts(const std::string& key, const CellComplex& complex,
                      const CellVolumes& volumes, int k, const Vector& w) const {
        if (!numbers().contains(key))
            return;
        SCOPED_TRACE(key);
        const auto& expected = numbers().at(key);
        HodgeSolver solver({{complex, volumes}, Side::primal, k});
        const auto parts = solver.decompose({Side::primal, k, w});
        const auto square = [&](const Cochain& part) {
            return inner_product({complex, volumes}, part, part);
        };
        EXPECT_GOLDEN(expected.at("total"), square({Side::primal, k, w}));
        EXPECT_GOLDEN(expected.at("exact"), square(parts.exact));
        EXPECT_GOLDEN(expected.at("coexact"), square(parts.coexact));
        EXPECT_GOLDEN(expected.at("harmonic"), square(parts.harmonic));
        EXPECT_EQ(expected.at("dim"), solver.harmonic_forms().cols());
    }
};

TEST_P(GoldenHodge, parts_of_the_test_forms) {
    const auto relative = relative_to_boundary(mesh().P());
    const auto volumes = relative_volumes(relative, mesh().volumes);
    for (int k = 1; k <= 2; ++k) {
        expect_parts(fmt::format("hodge{}_absolute", k), mesh().P(), mesh().volumes, k, form(k));
        expect_parts(fmt::format("hodge{}_relative", k), relative.complex, volumes, k,
                     relative.restrict(k, form(k)));
    }
}

TEST_P(GoldenHodge, spectra_relative_to_the_boundary) {
    const auto relative = relative_to_boundary(mesh().P());
    const auto volumes = relative_volumes(relative, mesh().volumes);
    for (int k = 0; k <= mesh().n(); ++k) {
        const auto key = fmt::format("spectrum_relative{}", k);
        if (!numbers().contains(key))
            continue;
        const std::vector<double> expected = numbers().at(key);
        const auto modes = spectrum({{relative.complex, volumes}, Side::primal, k},
                                    {.count = static_cast<Index>(expected.size())});
        for (std::size_t i = 0; i < expected.size(); ++i)
            EXPECT_NEAR(modes.eigenvalues[i], expected[i], 1e-7 * (1 + expected[i]))
                << key << ", " << i;
    }
}

POLYDEC_OVER_GOLDEN_FORMS(GoldenHodge);

} // namespace polydec::test::in_golden_hodge
