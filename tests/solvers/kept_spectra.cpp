// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_kept_spectra {

/// What a run tells of on its way.
std::vector<DenseMatrix> told_of(const FormSpace& space, SpectrumOptions options) {
    std::vector<DenseMatrix> all;
    options.found = [&](const DenseMatrix& vectors) { all.push_back(vectors); };
    spectrum(space, options);
    return all;
}

void expect_same(const Spectrum& one, const Spectrum& other) {
    EXPECT_TRUE(one.certificate.complete);
    for (Index i = 0; i < other.eigenvalues.size(); ++i)
        EXPECT_LE(std::abs(one.eigenvalues[i] - other.eigenvalues[i]),
                  one.radii[i] + other.radii[i])
            << i;
}

TEST(KeptSpectra, go_on_to_the_same_eigenvalues_on_both_sides_in_every_degree) {
    for (const Mesh& input : {icosphere(6), torus(12, 8), kuhn(3, 3)}) {
        const auto mesh = circumcentric(input);
        for (int degree = 0; degree <= mesh.dimension(); ++degree)
            for (const Side side : {Side::primal, Side::dual}) {
                const FormSpace space(mesh, side, degree);
                SpectrumOptions options{.count = 12};
                if (side == Side::dual && mesh.dimension() == 3 && degree > 0)
                    continue; // facets on the boundary have no duals
                const auto whole = spectrum(space, options);
                for (const DenseMatrix& vectors : told_of(space, options)) {
                    options.start = vectors;
                    expect_same(spectrum(space, options), whole);
                }
            }
    }
}

TEST(KeptSpectra, of_coexact_forms_go_on_as_well) {
    for (const Mesh& input : {icosphere(6), torus(12, 8), kuhn(3, 3)}) {
        const auto mesh = circumcentric(input);
        SpectrumOptions options{.count = 8};
        const auto of = [&] { return coexact_spectrum({mesh, Side::primal, 1}, options); };
        const auto whole = of();
        std::vector<DenseMatrix> all;
        options.found = [&](const DenseMatrix& vectors) { all.push_back(vectors); };
        int anew = 0, steps = 0;
        options.progress = [&](std::string_view) { ++anew; };
        of();
        ASSERT_FALSE(all.empty());
        options.found = {};
        options.start = all.back();
        options.progress = [&](std::string_view) { ++steps; };
        expect_same(of(), whole);
        EXPECT_LT(steps, anew);
    }
}

TEST(KeptSpectra, grow_in_parts_that_are_not_looked_for_again) {
    const FormSpace space(circumcentric(icosphere(10)), Side::primal, 0);
    SpectrumOptions options{.count = 100};
    const auto whole = spectrum(space, options);
    const auto parts = told_of(space, options);
    ASSERT_GE(parts.size(), 3u);
    EXPECT_LT(parts.front().cols(), 60);
    options.start = parts[parts.size() / 2];
    int steps = 0, anew = 0;
    options.progress = [&](std::string_view) { ++steps; };
    expect_same(spectrum(space, options), whole);
    options.start = {};
    options.found = [](const DenseMatrix&) {};
    options.progress = [&](std::string_view) { ++anew; };
    spectrum(space, options);
    EXPECT_LT(steps, anew);
}

TEST(KeptSpectra, are_right_whatever_they_are_begun_with) {
    const FormSpace space(circumcentric(icosphere(6)), Side::primal, 0);
    SpectrumOptions options{.count = 9};
    const auto whole = spectrum(space, options);
    const DenseMatrix found = told_of(space, options).back();
    const Index size = space.size();

    DenseMatrix twice(size, 8); // copies, noise, and what is far up
    twice << found.leftCols(2), found.leftCols(2), DenseMatrix::Random(size, 3), Vector::Zero(size);
    DenseMatrix without = found; // the first one is missing
    without.col(0) = found.col(1);
    DenseMatrix spoiled = found;
    spoiled.col(3) += 1e-4 * Vector::Unit(size, 0);
    for (const DenseMatrix& start : {twice, without, spoiled}) {
        options.start = start;
        expect_same(spectrum(space, options), whole);
    }
    options.start = DenseMatrix::Zero(3, 2);
    EXPECT_REFUSED(spectrum(space, options), "2 start vectors", "3 numbers", "362");
}

} // namespace polydec::test::in_kept_spectra
