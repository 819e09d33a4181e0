// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_proxy_vectors {

Discretization scaled(Mesh mesh, double scale) {
    mesh.points *= scale;
    return discretize(std::move(mesh));
}

std::vector<Discretization> flat_meshes(double scale) {
    return {scaled(grid(3, 2), scale), scaled(well_centered(3), scale),
            scaled(kuhn({2, 2, 1}), scale), scaled(kuhn(4, 1), scale)};
}

TEST(ProxyVectors, OfConstantFieldsAreThatFieldForFormsOfAllKinds) {
    for (const double scale : {1.0, std::ldexp(1.0, -60)})
        for (const Discretization& mesh : flat_meshes(scale)) {
            const int n = mesh.dimension();
            const Vector X = random_vector(n, 3);
            const auto constant = [&](const Vector&) { return X; };
            const SmoothForm along = circulation_form(constant), flux = flux_form(constant);
            const auto expect = [&](const Cochain& form, Proxy proxy, const char* what) {
                for (const DenseMatrix& rows : {vectors_at_cells(mesh, form, proxy),
                                                vectors_at_vertices(mesh, form, proxy)}) {
                    ASSERT_GT(rows.rows(), 0) << what;
                    EXPECT_WITHIN(rows.rowwise(), X.transpose(), 1e-12) << what << n;
                }
            };
            const Proxy through = n == 2 ? Proxy::flux : Proxy::automatic;
            expect(de_rham(mesh, 1, along), Proxy::automatic, "circulations");
            expect(de_rham(mesh, n - 1, flux), through, "fluxes");
            expect(dual_de_rham(mesh, 1, along), Proxy::automatic, "dual circulations");
            expect(dual_de_rham(mesh, n - 1, flux), through, "dual fluxes");
            EXPECT_EQ(vectors_at_cells(mesh, {Side::primal, 0, X}).size(), 0);
        }
}

TEST(ProxyVectors, AtVerticesAreMeansByVolume) {
    const Mesh mesh = grid(2, 1, 3.0, 1.0);
    const Discretization two = discretize(mesh);
    ASSERT_EQ(two.complex().size(2), 2);
    const DenseMatrix means = means_at_vertices(two, Vector{{1.0, 4.0}});
    std::vector<double> sorted(means.data(), means.data() + means.size());
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(sorted, (std::vector<double>{1, 1, 2.5, 2.5, 4, 4}));
}

} // namespace polydec::test::in_proxy_vectors
