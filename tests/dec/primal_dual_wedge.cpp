// SPDX-License-Identifier: MIT
#include "tests/dec/products.h"

namespace polydec::test::in_primal_dual_wedge {

constexpr double rounding = 1e-12;

class PrimalDualWedges : public OverMeshes {};

TEST_P(PrimalDualWedges, add_to_inner_products) {
    for (const auto& [name, complex, volumes] : both(mesh()))
        for (int k = 0; k <= mesh().n(); ++k) {
            const auto a = random_form(complex, Side::primal, k, 1);
            const auto b = random_form(complex, Side::primal, k, 2);
            const Vector terms = primal_dual_wedge(complex, a, star({complex, volumes}, b));
            EXPECT_NEAR(terms.sum(), inner_product({complex, volumes}, a, b),
                        rounding * terms.cwiseAbs().sum())
                << name << ", k = " << k;
        }
}

TEST_P(PrimalDualWedges, sum_by_parts) {
    const int n = mesh().n();
    for (const auto& [name, complex, volumes] : both(mesh()))
        for (int k = 0; k < n; ++k) {
            const auto a = random_form(complex, Side::primal, k, 1);
            const auto b = random_form(complex, Side::dual, n - k - 1, 2);
            const Vector first = primal_dual_wedge(complex, d(complex, a), b);
            const Vector second =
                (k % 2 == 0 ? 1 : -1) * primal_dual_wedge(complex, a, d(complex, b));
            const double size = first.cwiseAbs().sum();
            EXPECT_LE(std::abs(first.sum() + second.sum()), rounding * size)
                << name << ", k = " << k;
            if (size > 0) {
                EXPECT_GT(std::abs(first.sum() - second.sum()), 1e-6 * size)
                    << name << ", k = " << k << ", with the wrong sign";
            }
        }
}

POLYDEC_OVER_MESHES(PrimalDualWedges);

/// How far the product of constant k-forms, the second a dual one, is from their integral over the
/// flat mesh.
double integral_error(const Merged& mesh, const Metric& metric, int k) {
    const auto N = static_cast<Index>(mesh.points.cols());
    const Vector a = random_vector(coefficients(N, k), 3), b = random_vector(coefficients(N, k), 4);
    const auto form = [&](const Vector& c) -> Cochain {
        const Vector values = integrate(mesh.K(), mesh.points, k, constant_form(c));
        const bool on_simplices = &metric.complex == &mesh.K();
        return {Side::primal, k,
                on_simplices ? values : Vector(primal_to_merged(mesh.merging(), k) * values)};
    };
    const Vector terms =
        primal_dual_wedge(metric.complex, form(a), star({metric.complex, metric.volumes}, form(b)));
    const double volume = metric.volumes.primal(mesh.n()).sum();
    return std::abs(terms.sum() - a.dot(b) * volume) / (a.norm() * b.norm() * volume);
}

TEST(PrimalDualWedgesOfConstants, are_integrated_over_boxes) {
    for (const char* name : {"segments4", "rectangles", "hex4", "wellcentred4", "boxes", "bcc2",
                             "fcc1", "tesseracts2", "kuhn5"})
        for (const auto& metric : both(merged(name)))
            for (int k = 0; k <= merged(name).n(); ++k)
                EXPECT_LE(integral_error(merged(name), metric, k), rounding)
                    << name << ", " << metric.name << ", k = " << k;
}

TEST(PrimalDualWedgesOfConstants, are_integrated_only_up_to_what_the_boundary_does) {
    // the vertices of a facet share it unevenly; where facets meet, that cancels
    for (const auto& metric : both(merged("obtuse4")))
        for (int k = 1; k < 4; ++k)
            EXPECT_GT(integral_error(merged("obtuse4"), metric, k), 1e-4) << "k = " << k;
}

TEST(PrimalDualWedgeErrors, name_both_forms) {
    const auto& P = merged("grid4").P();
    const auto one = random_form(P, Side::primal, 1, 1);
    const auto dual = random_form(P, Side::dual, 1, 1), other = random_form(P, Side::dual, 2, 1);
    EXPECT_REFUSED(primal_dual_wedge(P, one, other), "primal-dual", "primal 1-form", "dual 2-form");
    EXPECT_REFUSED(primal_dual_wedge(P, dual, one), "primal-dual", "dual 1-form", "primal 1-form");
}

} // namespace polydec::test::in_primal_dual_wedge
