// SPDX-License-Identifier: MIT
#include "dec/metric/circumsphere.h"
#include "tests/support/scales.h"
#include "tests/support/test.h"

namespace polydec::test::in_zeros {

/// The facets that merging removes: in these meshes, those whose dual is zero.
std::vector<Index> removed_facets(const Discretization& mesh) {
    const int n = mesh.dimension();
    std::vector<Index> facets;
    for (Index f = 0; f < mesh.input().size(n - 1); ++f)
        if (mesh.merging().carriers(n - 1)[f].dimension == n)
            facets.push_back(f);
    return facets;
}

std::vector<Mesh> meshes_of_boxes() {
    return {kuhn(1, 4),          grid(8, 8),         kuhn(3, 4),         kuhn(4, 4),
            mesh_named("kuhn5"), uv_sphere(16, 12),  torus(12, 8),       layers(2, 6, 1e-3),
            layers(2, 6, 1e-6),  layers(3, 3, 1e-3), layers(3, 3, 1e-6), graded(2, 8, 3e4),
            graded(3, 5, 3e4)};
}

/// In directions that no coordinate is exact for.
Mesh turned(const Mesh& mesh, double shift) {
    return transformed(mesh, random_isometry(static_cast<Index>(mesh.points.cols()), 5), 1, shift);
}

TEST(Zeros, are_the_facets_within_boxes_wherever_these_lie_and_however_thin_they_are) {
    for (const Mesh& mesh : meshes_of_boxes())
        for (const Mesh& placed : {mesh, turned(mesh, 0), turned(mesh, 10)}) {
            const auto bundle = discretize(placed);
            const int n = bundle.dimension();
            EXPECT_EQ(star(bundle.input_geometry().volumes(), n - 1).zeros(),
                      removed_facets(bundle));
            for (int k = 0; k <= n; ++k) {
                EXPECT_TRUE(star(bundle.volumes(), k).zeros().empty()) << k;
                EXPECT_TRUE(star(bundle.volumes(), k).negatives().empty()) << k;
            }
        }
}

TEST(Zeros, are_the_same_from_lengths_alone) {
    for (const Mesh& mesh : {grid(8, 8), kuhn(3, 4), uv_sphere(16, 12), layers(2, 6, 1e-3)}) {
        const auto bundle = discretize(length_mesh(mesh));
        EXPECT_EQ(star(bundle.input_geometry().volumes(), mesh.simplices.cols() - 2).zeros(),
                  removed_facets(discretize(mesh)));
    }
}

/// Cells whose star is below 1e-12 of the largest one anywhere.
Index small_against_the_largest(const CellVolumes& volumes, int k) {
    const Vector values = star(volumes, k).diagonal().cwiseAbs();
    return static_cast<Index>((values.array() <= 1e-12 * values.maxCoeff()).count());
}

Discretization large_and_small_sphere() {
    return discretize(
        united(icosphere(3), transformed(icosphere(3), DenseMatrix::Identity(3, 3), 1e-6)));
}

TEST(Zeros, do_not_depend_on_what_else_is_in_the_mesh) {
    const auto spheres = large_and_small_sphere();
    const auto grid3 = discretize(graded(3, 6, 3e4));
    for (int k = 0; k <= 2; ++k) {
        EXPECT_TRUE(star(spheres.volumes(), k).zeros().empty()) << k;
        EXPECT_TRUE(star(spheres.volumes(), k).negatives().empty()) << k;
        EXPECT_TRUE(star(grid3.volumes(), k).zeros().empty()) << k;
    }
}

TEST(ZerosBroken, by_the_largest_entry_call_a_small_sphere_and_small_boxes_nothing) {
    const auto spheres = large_and_small_sphere();
    EXPECT_GT(small_against_the_largest(spheres.volumes(), 0), 0);
    EXPECT_GT(small_against_the_largest(spheres.volumes(), 2), 0);
    EXPECT_GT(small_against_the_largest(discretize(graded(3, 6, 3e4)).volumes(), 0), 0);
}

TEST(Zeros, are_no_small_duals) {
    // a rectangle whose diagonal's dual has 1e-9 of its length
    auto mesh = made_of({{0, 0}, {1, 0}, {1, 1}, {0, 1 + 2e-9}}, {{0, 1, 2}, {0, 2, 3}});
    const auto volumes = discretize(mesh, {.criterion = MergeCriterion::none}).volumes();
    EXPECT_TRUE(star(volumes, 1).zeros().size() < 5);
    const auto zero = star(volumes, 1).zeros();
    for (const Index e : zero)
        EXPECT_LE(std::abs(volumes.dual(1)[e]), 1e-13);
}

TEST(Circumspheres, of_flat_simplices_are_refused_by_name) {
    const auto mesh = made_of({{9, 9}, {0, 0}, {1, 1}, {3, 3}}, {{1, 2, 3}});
    const Words expected{"2-simplex", "vertices 1, 2, 3", "volume", "circumsphere"};
    const SimplicialComplex K(mesh.simplices);
    EXPECT_REFUSED(circumradii(K, mesh.points, 2), expected);
}

TEST(Circumspheres, answer_for_no_other_simplex) {
    const auto mesh = made_of({{0, 0}, {1, 0}, {0, 1}, {2, 0}}, {{0, 1, 2}, {0, 1, 3}});
    Circumsphere sphere;
    const auto row = [&](Index s) { return Corners{mesh.points, vertices(mesh.simplices, s)}; };
    ASSERT_TRUE(sphere.look_at(row(0)));
    EXPECT_NEAR(sphere.radius(), std::sqrt(0.5), 1e-15);
    ASSERT_FALSE(sphere.look_at(row(1)));
    EXPECT_EQ(sphere.volume(), 0);
    const Words expected{"simplex", "volume", "circumsphere"};
    EXPECT_REFUSED(sphere.radius(), expected);
    EXPECT_REFUSED(sphere.barycentric(0), expected);
    EXPECT_REFUSED(sphere.height(0, 1), expected);
    EXPECT_REFUSED(Circumsphere().radius(), expected);
}

} // namespace polydec::test::in_zeros
