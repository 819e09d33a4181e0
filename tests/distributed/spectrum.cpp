// SPDX-License-Identifier: MIT
#include "distributed/spectrum.h"

#include "tests/distributed/compare.h"

namespace polydec::test::in_spectrum {

constexpr Index most_values = 12;

Index most_cells() {
    return is_full_sweep() ? 600 : 120;
}

std::optional<Spectrum> of_one_process(const Discretization& mesh, int degree,
                                       const SpectrumOptions& options) {
    try {
        return spectrum({mesh, Side::primal, degree}, options);
    } catch (const Error&) {
        return std::nullopt;
    }
}

/// Whether both find the same, each within the other's radii.
void expect_equal(const Spectrum& found, const Spectrum& expected, const std::string& in) {
    ASSERT_EQ(found.eigenvalues.size(), expected.eigenvalues.size()) << in;
    const double largest = expected.eigenvalues.cwiseAbs().maxCoeff();
    for (Index i = 0; i < found.eigenvalues.size(); ++i) {
        const double distance = std::abs(found.eigenvalues[i] - expected.eigenvalues[i]);
        EXPECT_LE(distance, found.radii[i] + expected.radii[i]) << in << ", number " << i;
        EXPECT_LE(distance, 1e-9 * (1 + largest)) << in << ", number " << i;
        EXPECT_LE(found.radii[i], 1e-6 * (1 + largest)) << in << ", number " << i;
    }
    const auto &ours = found.certificate, &theirs = expected.certificate;
    EXPECT_TRUE(ours.complete) << in;
    EXPECT_EQ(ours.below_shift, theirs.below_shift) << in;
    EXPECT_EQ(ours.returned_below_shift, theirs.returned_below_shift) << in;
}

/// By degree, so that none takes long where many ranks share a core.
class DistributedSpectra : public testing::TestWithParam<int> {};

TEST_P(DistributedSpectra, are_those_of_one_process_with_their_certificates) {
    const auto ranks = Ranks::all();
    const int k = GetParam();
    std::size_t compared = 0, there_are = 0;
    for (const auto& [name, given] : swept(ranks)) {
        const Discretization whole = circumcentric(given);
        const Index size = k <= whole.dimension() ? whole.complex().size(k) : 0;
        there_are += k <= whole.dimension() ? 1 : 0;
        if (size > most_cells() || size < 2)
            continue;
        const DistributedMesh mesh = discretized(ranks, given, some_ownerships(ranks, name).back());
        const SpectrumOptions options{.count = std::min(size - 1, most_values)};
        const auto expected = of_one_process(whole, k, options);
        std::optional<Spectrum> found;
        try {
            found = spectrum(ranks, mesh, Side::primal, k, options);
        } catch (const InvalidInput&) { // where stars are not positive
            continue;
        }
        ASSERT_TRUE(expected) << name << ", degree " << k;
        expect_equal(*found, *expected, fmt::format("{}, degree {}", name, k));
        ++compared;
    }
    EXPECT_GT(3 * compared, there_are);
}

INSTANTIATE_TEST_SUITE_P(Degrees, DistributedSpectra, testing::Range(0, 5));

TEST(DistributedSpectrum, of_dual_functions_is_refused_where_three_cells_meet) {
    const auto ranks = Ranks::all();
    const Mesh book = made_of({{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 0, 1}, {0.5, -1, 0.5}},
                              {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
    const DistributedMesh mesh = discretized(ranks, book, Ownership::morton);
    EXPECT_REFUSED(spectrum(ranks, mesh, Side::dual, 0, {.count = 1}), "3 cells meet at facet");
    EXPECT_EQ(spectrum(ranks, mesh, Side::primal, 0, {.count = 1}).eigenvalues.size(), 1);
}

TEST(DistributedSpectrum, of_all_eigenvalues_needs_no_count) {
    const auto ranks = Ranks::all();
    const Mesh& given = mesh_named("grid4");
    const DistributedMesh mesh = discretized(ranks, given, Ownership::morton);
    const auto size = static_cast<Index>(mesh.cells.degree(2).count);
    const auto all = spectrum(ranks, mesh, Side::dual, 0, {.count = size});
    EXPECT_EQ(all.eigenvalues.size(), size);
    EXPECT_TRUE(all.certificate.complete);
    EXPECT_THROW(spectrum(ranks, mesh, Side::primal, 0, {.count = size + 100}), InvalidInput);
    EXPECT_THROW(spectrum(ranks, mesh, Side::primal, 3), InvalidInput);
}

} // namespace polydec::test::in_spectrum
