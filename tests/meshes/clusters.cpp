// SPDX-License-Identifier: MIT
#include "tests/meshes/propositions.h"

namespace polydec::test::in_clusters {

/// Numbers of corners of the merged cells, descending.
std::vector<std::size_t> corner_counts(const Discretization& mesh) {
    const int n = mesh.dimension();
    std::vector<std::set<Index>> corners(static_cast<std::size_t>(mesh.complex().size(n)));
    const auto& carriers = mesh.merging().carriers(n);
    for (std::size_t t = 0; t < carriers.size(); ++t)
        for (int i = 0; i <= n; ++i)
            corners[carriers[t].cell].insert(
                mesh.input().simplices(n)(static_cast<Eigen::Index>(t), i));
    std::vector<std::size_t> result;
    for (const auto& cell : corners)
        result.push_back(cell.size());
    std::sort(result.rbegin(), result.rend());
    return result;
}

/// Least star of facets between two cells, relative to the size of the facet.
double least_inner_star(const Mesh& input, MergeCriterion criterion) {
    const auto mesh = discretize(input, {.criterion = criterion});
    const int n = mesh.dimension();
    double least = std::numeric_limits<double>::infinity();
    for (Index f = 0; f < mesh.complex().size(n - 1); ++f)
        if (mesh.complex().coface_counts(n - 1)[f] == 2)
            least = std::min(least, mesh.volumes().dual(n - 1)[f]);
    return least;
}

class Clusters : public testing::TestWithParam<ClusterOptions> {};

TEST_P(Clusters, fill_the_cube_with_positive_simplices_in_a_ball) {
    const Mesh mesh = sphere_clusters(GetParam());
    EXPECT_NEAR(total_volume(mesh), 1.0, 1e-12);
    EXPECT_GT(least_determinant(mesh), 0.0);
    EXPECT_EQ(euler_characteristic(mesh), 1);
    const FacetTally tally = tally_facets(mesh);
    EXPECT_EQ(tally.clashing + tally.branching, 0);
}

TEST_P(Clusters, are_delaunay) {
    const Mesh mesh = sphere_clusters(GetParam());
    EXPECT_GT(least_inner_star(mesh, MergeCriterion::none), -1e-5);
    // a vertex that is moved away makes it fail
    Mesh moved = mesh;
    const auto last = moved.points.rows() - 1;
    moved.points.row(last).array() += 0.6 / GetParam().cells_per_side;
    EXPECT_LT(least_inner_star(moved, MergeCriterion::none), -1e-5);
}

TEST_P(Clusters, become_one_cell_each) {
    const auto mesh = discretize(sphere_clusters(GetParam()));
    const auto counts = corner_counts(mesh);
    for (int sphere = 0; sphere < GetParam().spheres; ++sphere)
        EXPECT_EQ(counts[sphere], static_cast<std::size_t>(GetParam().points_on_sphere));
    EXPECT_LT(counts[GetParam().spheres], 2U << static_cast<unsigned>(mesh.dimension()));
    EXPECT_EQ(betti_numbers(mesh.complex()), betti_numbers(mesh.input()));
    EXPECT_LT(corner_counts(
                  discretize(sphere_clusters(GetParam()), {.criterion = MergeCriterion::none}))[0],
              counts[0]);
}

INSTANTIATE_TEST_SUITE_P(
    Spheres, Clusters,
    testing::Values(
        ClusterOptions{.dimension = 2,
                       .cells_per_side = 12,
                       .spheres = 3,
                       .points_on_sphere = 20,
                       .radius = 0.12},
        ClusterOptions{.seed = 1}, ClusterOptions{.seed = 2},
        ClusterOptions{.cells_per_side = 12, .spheres = 4, .radius = 0.15, .seed = 3},
        ClusterOptions{.dimension = 4, .cells_per_side = 3, .points_on_sphere = 12, .radius = 0.2}),
    [](const auto& instance) {
        return "n" + std::to_string(instance.param.dimension) + "_seed" +
               std::to_string(instance.index);
    });

TEST(ClustersOfPoints, are_the_same_for_the_same_seed) {
    EXPECT_TRUE(same_geometry(sphere_clusters({.seed = 5}), sphere_clusters({.seed = 5})));
    EXPECT_FALSE(same_geometry(sphere_clusters({.seed = 5}), sphere_clusters({.seed = 6})));
}

TEST(ClustersOfPoints, ask_for_room) {
    EXPECT_REFUSED(sphere_clusters({.spheres = 9}), "sphere_clusters", "1 spheres", "0.25",
                   "0.08333333333333333");
    EXPECT_REFUSED(sphere_clusters({.dimension = 7}), "sphere_clusters", "dimension", "7", "2",
                   "6");
    EXPECT_REFUSED(sphere_clusters({.points_on_sphere = 3}), "sphere_clusters", "points_on_sphere",
                   "3", "4", "10000");
}

TEST(SplitBoxes, merge_to_the_grid_of_boxes_and_kuhn_is_one_of_them) {
    for (const auto& cells : {std::vector<int>{5, 3}, {2, 3, 2}, {2, 1, 1, 2}, {1, 1, 1, 1, 1}}) {
        const auto random = discretize(split_boxes(cells, {}, 11)),
                   regular = discretize(kuhn(cells));
        for (int k = 0; k <= regular.dimension(); ++k)
            EXPECT_EQ(random.complex().size(k), regular.complex().size(k));
        EXPECT_FALSE(same_geometry(split_boxes(cells, {}, 11), split_boxes(cells, {}, 12)));
    }
}

} // namespace polydec::test::in_clusters
