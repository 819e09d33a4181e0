// SPDX-License-Identifier: MIT
#include "dec/forms/star.h"
#include "dec/metric/circumcentric_volumes.h"
#include "meshes/generate.h"
#include "meshes/rearrange.h"
#include "tests/support/hand_made.h"
#include "tests/support/matrices.h"
#include "tests/support/over_meshes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace polydec::test::in_invariance {
namespace {

class Invariance : public OverMeshes {
protected:
    const Mesh& raw() const { return mesh_named(GetParam()); }
};

/// Whether the same simplices were merged to the same cells.
bool same_merging(const Merged& a, const Merged& b) {
    bool same = a.n() == b.n();
    for (int k = 0; same && k <= a.n(); ++k)
        same = equal(integers(a.merging().diamond(k)), integers(b.merging().diamond(k))) &&
               equal(integers(a.P().coboundary(k)), integers(b.P().coboundary(k)));
    return same;
}

/// Largest difference between star_k of K and P of the one and factor times that of the other.
double star_difference(const Merged& a, const Merged& b, int k, double factor) {
    return std::max(
        relative_difference(star(a.input_volumes, k).diagonal(),
                            factor * star(b.input_volumes, k).diagonal()),
        relative_difference(star(a.volumes, k).diagonal(), factor * star(b.volumes, k).diagonal()));
}

TEST_P(Invariance, stars_scale_by_powers_of_the_length_and_merging_does_not_change) {
    for (const double scale : {1e-8, 0.3, 1e8}) {
        const auto N = static_cast<Index>(raw().points.cols());
        const auto scaled = make_merged(transformed(raw(), DenseMatrix::Identity(N, N), scale));
        ASSERT_TRUE(same_merging(scaled, mesh())) << "scale " << scale;
        for (int k = 0; k <= mesh().n(); ++k) {
            const int power = mesh().n() - 2 * k;
            EXPECT_LE(star_difference(scaled, mesh(), k, std::pow(scale, power)), 1e-10)
                << "scale " << scale << ", k = " << k;
            EXPECT_GT(star_difference(scaled, mesh(), k, std::pow(scale, power + 1)), 0.1)
                << "with the wrong power";
        }
    }
}

TEST_P(Invariance, rigid_motions_change_no_star_and_no_merging) {
    for (const unsigned seed : {1U, 2U, 3U}) {
        const auto N = static_cast<Index>(raw().points.cols());
        const auto moved = make_merged(transformed(raw(), random_isometry(N, seed), 1.0, 0.7));
        ASSERT_TRUE(same_merging(moved, mesh()));
        for (int k = 0; k <= mesh().n(); ++k)
            EXPECT_LE(star_difference(moved, mesh(), k, 1), 1e-10) << "k = " << k;
    }
}

TEST_P(Invariance, more_coordinates_change_no_star_and_no_merging) {
    // but in N = n alone boundary faces without dual volume are told from bent ones
    if (mesh().n() > 2 && mesh().result.degenerate.boundary > 0)
        return;
    const auto N = static_cast<Index>(raw().points.cols());
    const DenseMatrix embedding = random_isometry(N + 2, 4).leftCols(N);
    const auto embedded = make_merged(transformed(raw(), embedding));
    ASSERT_TRUE(same_merging(embedded, mesh()));
    for (int k = 0; k <= mesh().n(); ++k)
        EXPECT_LE(star_difference(embedded, mesh(), k, 1), 1e-10) << "k = " << k;
}

TEST_P(Invariance, a_shear_changes_the_stars) {
    const auto N = static_cast<Index>(raw().points.cols());
    if (mesh().n() < 2)
        return;
    DenseMatrix shear = DenseMatrix::Identity(N, N);
    shear(0, 1) = 0.3;
    const Mesh sheared = transformed(raw(), shear);
    const SimplicialComplex K(sheared.simplices);
    const Points points = vertex_points(K, sheared.points);
    const auto volumes = circumcentric_volumes(K, points);
    EXPECT_GT(
        relative_difference(star(volumes, 1).diagonal(), star(mesh().input_volumes, 1).diagonal()),
        1e-3);
}

TEST_P(Invariance, the_order_of_cells_changes_not_a_bit) {
    Mesh reversed = raw();
    reversed.simplices = raw().simplices.colwise().reverse();
    const auto other = make_merged(reversed);
    ASSERT_TRUE(same_merging(other, mesh()));
    for (int k = 0; k <= mesh().n(); ++k)
        EXPECT_EQ(star_difference(other, mesh(), k, 1), 0) << "k = " << k;
}

using Named = std::pair<std::vector<Index>, double>;

/// Star entries of P by the vertices of the cells, named as `old_number` says, in order.
std::vector<Named> named_stars(const Merged& m, int k, const std::vector<Index>& old_number) {
    const Vector values = star(m.volumes, k).diagonal();
    std::vector<Named> result;
    for (Index F = 0; F < m.P().size(k); ++F) {
        auto vertices = m.K().vertex_numbers(m.merging().vertices(k, F));
        for (Index& v : vertices)
            v = old_number[v];
        std::sort(vertices.begin(), vertices.end());
        result.emplace_back(vertices, values[F]);
    }
    std::sort(result.begin(), result.end());
    return result;
}

void expect_same_stars(const Merged& a, const std::vector<Index>& names_of_a, const Merged& b) {
    std::vector<Index> own_names(std::size_t(b.K().vertex_number(b.K().size(0) - 1)) + 1);
    for (std::size_t v = 0; v < own_names.size(); ++v)
        own_names[v] = static_cast<Index>(v);
    for (int k = 0; k <= b.n(); ++k) {
        const auto one = named_stars(a, k, names_of_a), other = named_stars(b, k, own_names);
        const double scale = star(b.volumes, k).diagonal().cwiseAbs().maxCoeff();
        ASSERT_EQ(one.size(), other.size()) << "k = " << k;
        for (std::size_t i = 0; i < one.size(); ++i) {
            ASSERT_EQ(one[i].first, other[i].first) << "k = " << k;
            EXPECT_NEAR(one[i].second, other[i].second, 1e-10 * scale) << "k = " << k;
        }
    }
}

TEST_P(Invariance, vertex_numbers_are_only_names) {
    for (const std::uint64_t seed : {1U, 2U}) {
        const auto renumbered = shuffled(raw(), seed);
        expect_same_stars(make_merged(renumbered.mesh), renumbered.vertices, mesh());
    }
}

POLYDEC_OVER_MESHES(Invariance);

struct GuardedCase {
    const char* name;
    Mesh mesh;
    double tolerance;
};

TEST(InvarianceOfGuardedMerging, vertex_numbers_are_only_names_at_tolerances_that_guards_rule) {
    const std::vector<GuardedCase> cases = {
        {"sphere", uv_sphere(64, 32), 0.12},
        {"torus", torus(100, 6), 0.2},
        {"squares", perturbed(grid(12, 12), 1e-3, 1), 0.02},
        {"cubes", perturbed(kuhn(3, 3), 2e-3, 1), 0.02},
        {"bumpy_sphere", perturbed(icosphere(6), 0.03, 3), 0.5}};
    for (const auto& [name, mesh, tolerance] : cases) {
        SCOPED_TRACE(name);
        const MergeOptions options{MergeCriterion::dual_length, tolerance};
        const auto original = make_merged(mesh, options);
        EXPECT_LT(original.P().size(original.n()), original.K().size(original.n()));
        for (const std::uint64_t seed : {1U, 2U, 3U}) {
            const auto renumbered = shuffled(mesh, seed);
            expect_same_stars(make_merged(renumbered.mesh, options), renumbered.vertices, original);
        }
    }
}

} // namespace
} // namespace polydec::test::in_invariance
