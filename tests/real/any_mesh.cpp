// SPDX-License-Identifier: MIT
//
// Automatic stars on meshes that are made with negative duals, and on every one below the folder of
// test data that is not large: spectra, Hodge decomposition and heat of 1-forms, which
// circumcentric stars refuse on most of them.
#include "tests/io/support.h"
#include "tests/real/samples.h"

namespace polydec::test::in_any_mesh {

constexpr Index most_edges = 10000;
constexpr Index most_harmonic = 60;

const DiscretizeOptions automatic{.star = StarKind::automatic};

std::optional<Discretization> made_ready(const std::filesystem::path& path) {
    try {
        return discretize(read_mesh(path), automatic);
    } catch (const Error&) {
        return std::nullopt; // what cannot be read is another test's
    }
}

/// Calls check(mesh) for every mesh that is made, and every file that is read; how many these are.
template <class Check>
int for_each_mesh(Check check) {
    int meshes = 0;
    for (const int n : {2, 3})
        for (const auto& name : samples(n)) {
            SCOPED_TRACE(name);
            check(discretize(mesh_of(name), automatic));
            ++meshes;
        }
    for (const char* folder : {"cad", "planar", "poly", "surface", "table2", "tet"})
        for (const auto& path : test::test_data(folder)) {
            if (std::filesystem::file_size(path) > 2000000)
                continue;
            const auto mesh = made_ready(path);
            if (!mesh || mesh->dimension() < 2 || mesh->complex().size(1) > most_edges)
                continue;
            SCOPED_TRACE(path.filename().string());
            check(*mesh);
            ++meshes;
        }
    return meshes;
}

TEST(AnyMesh, has_certified_spectra_with_as_many_zeros_as_harmonic_forms) {
    int refused = 0;
    const int meshes = for_each_mesh([&](const Discretization& mesh) {
        const Index harmonic = betti_numbers(mesh.complex())[1];
        if (harmonic > most_harmonic)
            return;
        const auto found = spectrum({mesh, Side::primal, 1}, {.count = harmonic + 2});
        EXPECT_TRUE(found.certificate.complete);
        for (Index i = 0; i < found.eigenvalues.size(); ++i)
            EXPECT_EQ(std::abs(found.eigenvalues[i]) <= found.radii[i], i < harmonic) << i;
        const auto circumcentric = mesh.with_stars(HodgeStars(mesh.volumes()));
        refused += refusal([&] {
                       spectrum({circumcentric, Side::primal, 1});
                   }) != "accepted"
                       ? 1
                       : 0;
    });
    EXPECT_GT(2 * refused, meshes); // by circumcentric stars
}

/// What info says of each degree and side.
TEST(AnyMesh, has_the_spectra_that_verdicts_promise) {
    int refused = 0;
    for (const int n : {2, 3})
        for (const auto& sample : samples(n)) {
            const auto plain = discretize(mesh_of(sample));
            for (const StarKind kind :
                 {StarKind::circumcentric, StarKind::galerkin, StarKind::automatic}) {
                const auto mesh = plain.with_stars(kind);
                for (const Side side : {Side::primal, Side::dual})
                    for (const auto& verdict : spectrum_verdicts(mesh, side)) {
                        const int k = verdict.cell_degree;
                        const int degree = side == Side::primal ? k : n - k;
                        const auto said = refusal([&] {
                            spectrum({mesh, side, degree}, {.count = 1});
                        });
                        EXPECT_EQ(said == "accepted", verdict.exists)
                            << sample << ", " << name(kind) << ' ' << degree << ": " << said;
                        refused += kind == StarKind::circumcentric && !verdict.exists;
                        EXPECT_TRUE(verdict.reason.empty() || kind == StarKind::circumcentric)
                            << sample << ", " << name(kind) << ": " << verdict.reason;
                    }
            }
        }
    EXPECT_GE(refused, 20); // 1-forms, and 2-forms of solids
}

TEST(AnyMesh, has_orthogonal_decompositions_and_heat_that_does_not_grow) {
    for_each_mesh([](const Discretization& mesh) {
        const HodgeStar star = mesh.stars()[1];
        const Vector w = random_vector(star.size(), 1);
        const double all = w.dot(star * w);
        const auto parts = hodge_decomposition({mesh, Side::primal, 1}, {Side::primal, 1, w});
        const auto product = [&](const Cochain& a, const Cochain& b) {
            return std::abs(a.values.dot(star * b.values)) / all;
        };
        EXPECT_LE(product(parts.exact, parts.coexact), 1e-10);
        EXPECT_LE(product(parts.exact, parts.harmonic), 1e-10);
        EXPECT_LE(product(parts.coexact, parts.harmonic), 1e-10);
        const double step = std::pow(mesh.volumes().primal(1).mean(), 2);
        Evolution heat({{.space = {mesh, Side::primal, 1}, .start = w, .diffusion = 1}}, {},
                       {.integrator = "backward-euler", .steps = {.fixed_step = step}});
        heat.march(step);
        const Vector later = heat.form(0).values;
        EXPECT_LE(later.dot(star * later), all * (1 + 1e-12));
    });
}

} // namespace polydec::test::in_any_mesh
