// SPDX-License-Identifier: MIT
#include "tests/laws/over_hostile_meshes.h"

namespace polydec::test::in_cells {

/// By how much sum |s||*s| misses C(n,k) |K|, beside what the sum is made of.
double defect_of_dual_volumes(const CellVolumes& volumes, int k, double factor = 1) {
    const int n = volumes.dimension();
    const double whole = binomial(n, k) * volumes.primal(n).sum();
    const Vector& primal = volumes.primal(k);
    return std::abs(factor * primal.dot(volumes.dual(k)) - whole) /
           (primal.dot(volumes.terms(k).vector()) + whole);
}

Vector sorted(Vector values) {
    std::sort(values.begin(), values.end());
    return values;
}

/// The largest difference of the sorted entries, beside the largest of their terms.
double difference_of_duals(const CellVolumes& a, const CellVolumes& b, int k, double factor) {
    const Vector difference = sorted(a.dual(k)) - factor * sorted(b.dual(k));
    return difference.cwiseAbs().maxCoeff() / a.terms(k).vector().maxCoeff();
}

bool same_counts(const CellComplex& a, const CellComplex& b) {
    bool same = a.dimension() == b.dimension();
    for (int k = 0; same && k <= a.dimension(); ++k)
        same = a.size(k) == b.size(k);
    return same;
}

TEST(HostileMeshes, have_derivatives_whose_square_is_zero) {
    EXPECT_TRUE(holds_on_hostile_discretizations("d d = 0", [](const Discretization& mesh) {
        for (const CellComplex* complex :
             {&mesh.complex(), static_cast<const CellComplex*>(&mesh.input())})
            for (int k = 0; k + 1 < mesh.dimension(); ++k)
                RC_ASSERT(is_zero(integers(complex->coboundary(k + 1)) *
                                  integers(complex->coboundary(k))));
    }));
}

TEST(HostileMeshes, keep_Euler_and_Betti_numbers_when_they_are_merged) {
    EXPECT_TRUE(holds_on_hostile_discretizations("topology stays", [](const Discretization& mesh) {
        RC_ASSERT(euler_characteristic(mesh.input()) == euler_characteristic(mesh.complex()));
        RC_ASSERT(betti_numbers(mesh.input()) == betti_numbers(mesh.complex()));
    }));
}

TEST(HostileMeshes, are_filled_by_their_duals) {
    const auto fills = [](const CellVolumes& volumes, double bound) {
        for (int k = 0; k <= volumes.dimension(); ++k) {
            RC_ASSERT(volumes.primal(k).allFinite());
            RC_ASSERT(volumes.dual(k).allFinite());
            RC_ASSERT(volumes.primal(k).minCoeff() > 0);
            RC_ASSERT(defect_of_dual_volumes(volumes, k) <= bound);
        }
    };
    EXPECT_TRUE(holds_on_hostile_discretizations(
        "sum |s||*s| = C(n,k)|K|", [&](const Discretization& mesh) {
            fills(mesh.input_geometry().volumes(), 1e-11);
            // the duals of removed facets, as long as the tolerance allows, are left out
            fills(mesh.volumes(), 10 * mesh.options().tolerance);
        }));
}

TEST(HostileMeshes, do_not_depend_on_the_order_of_their_input) {
    EXPECT_TRUE(holds_on_hostile_meshes("order", [](const Mesh& mesh) {
        const auto first = unless_refused([&] { return discretize(mesh); });
        const auto second = unless_refused([&] { return discretize(shuffled(mesh, 7).mesh); });
        RC_ASSERT(first.has_value() == second.has_value());
        if (!first)
            return;
        RC_ASSERT(same_counts(first->complex(), second->complex()));
        for (int k = 0; k < first->dimension(); ++k)
            RC_ASSERT(difference_of_duals(first->volumes(), second->volumes(), k, 1) <= 1e-7);
    }));
}

TEST(HostileMeshes, scale_by_powers_of_two_without_a_change_of_a_bit) {
    EXPECT_TRUE(holds_on_hostile_meshes("scale", [](const Mesh& mesh) {
        const double scale = 0x1p-20;
        Mesh scaled = mesh;
        scaled.points *= scale;
        const auto first = unless_refused([&] { return discretize(mesh); });
        const auto second = unless_refused([&] { return discretize(scaled); });
        RC_ASSERT(first.has_value() == second.has_value());
        if (!first)
            return;
        RC_ASSERT(same_counts(first->complex(), second->complex()));
        const double in_units = second->unit() / (first->unit() * scale);
        for (int k = 0; k < first->dimension(); ++k)
            RC_ASSERT(difference_of_duals(first->volumes(), second->volumes(), k,
                                          std::pow(in_units, first->dimension() - k)) == 0);
    }));
}

TEST(HostileMeshes, would_show_a_wrong_factor) {
    const auto mesh = discretize(mesh_named("torus8x6"));
    EXPECT_LE(defect_of_dual_volumes(mesh.volumes(), 1), 1e-14);
    EXPECT_GT(defect_of_dual_volumes(mesh.volumes(), 1, 1.1), 1e-3);
    EXPECT_EQ(difference_of_duals(mesh.volumes(), mesh.volumes(), 1, 1), 0);
    EXPECT_GT(difference_of_duals(mesh.volumes(), mesh.volumes(), 1, 1.1), 1e-3);
}

} // namespace polydec::test::in_cells
