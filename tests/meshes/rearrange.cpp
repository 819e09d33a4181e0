// SPDX-License-Identifier: MIT
#include "tests/meshes/propositions.h"

namespace polydec::test::in_rearrange {

/// The result is the mesh under the numbers that come with it.
void expect_renumbered(const Renumbered& result, const Mesh& mesh) {
    for (Index v = 0; v < mesh.points.rows(); ++v)
        EXPECT_EQ(result.mesh.points.row(v), mesh.points.row(result.vertices[v]));
    for (Index cell = 0; cell < mesh.simplices.rows(); ++cell)
        for (Index i = 0; i < mesh.simplices.cols(); ++i)
            EXPECT_EQ(result.vertices[result.mesh.simplices(cell, i)],
                      mesh.simplices(result.cells[cell], i));
    EXPECT_TRUE(same_geometry(result.mesh, mesh));
}

TEST(AscendingOrder, is_that_of_a_stable_sort) {
    std::mt19937_64 engine(5);
    for (const std::size_t size : {0, 1, 2, 100, 5000})
        for (const std::uint64_t mask : {~std::uint64_t{0}, std::uint64_t{0xFF000000000000FF},
                                         std::uint64_t{0x3F}, std::uint64_t{0}}) {
            std::vector<std::uint64_t> keys;
            for (std::size_t i = 0; i < size; ++i)
                keys.push_back(engine() & mask);
            std::vector<Index> expected(size);
            std::iota(expected.begin(), expected.end(), 0);
            std::stable_sort(expected.begin(), expected.end(),
                             [&](Index a, Index b) { return keys[a] < keys[b]; });
            EXPECT_EQ(ascending_order(keys), expected) << size << " keys of " << mask;

            const auto [order, ends] = groups_of(keys);
            EXPECT_EQ(order.size(), size);
            EXPECT_TRUE(std::is_sorted(ends.begin(), ends.end()));
            for (std::size_t i = 0, group = 0; i + 1 < size; ++i) {
                const bool ends_here = ends[group] == static_cast<Index>(i) + 1;
                group += ends_here ? 1 : 0;
                if (keys[order[i]] == keys[order[i + 1]]) {
                    EXPECT_FALSE(ends_here);
                }
                if (ends_here) {
                    EXPECT_LT(keys[order[i]], keys[order[i + 1]]);
                }
            }
        }
}

TEST(Perturbed, moves_every_coordinate_by_at_most_the_amplitude) {
    const Mesh mesh = kuhn(3, 6);
    const Mesh moved = perturbed(mesh, 0.01, 7);
    const Points difference = moved.points - mesh.points;
    EXPECT_LE(difference.cwiseAbs().maxCoeff(), 0.01 + 1e-16);
    EXPECT_GT(difference.maxCoeff(), 0.0095);
    EXPECT_LT(difference.minCoeff(), -0.0095);
    EXPECT_LT(std::abs(difference.mean()), 0.001);
    EXPECT_EQ(moved.simplices, mesh.simplices);
}

TEST(Perturbed, gives_the_same_mesh_for_the_same_seed_on_every_machine) {
    const Mesh mesh{Points::Zero(1, 2), Simplices(0, 1), {}};
    // The 10000th number of the engine is fixed by the C++ standard; its first two from the
    // default seed are 14514284786278117030 and 4620546740167642908.
    const Mesh moved = perturbed(mesh, 1.0, 5489);
    EXPECT_EQ(moved.points(0, 0), 2.0 * (14514284786278117030ULL >> 11U) * 0x1p-53 - 1.0);
    EXPECT_EQ(moved.points(0, 1), 2.0 * (4620546740167642908ULL >> 11U) * 0x1p-53 - 1.0);
    EXPECT_NE(perturbed(mesh, 1.0, 1).points, perturbed(mesh, 1.0, 2).points);
}

TEST(Perturbed, leaves_the_mesh_for_the_amplitude_zero_and_refuses_a_wrong_one) {
    EXPECT_EQ(perturbed(grid(2, 2), 0.0, 1).points, grid(2, 2).points);
    EXPECT_REFUSED(perturbed(grid(1, 1), -1.0, 1), "perturbed", "amplitude", "-1");
    EXPECT_REFUSED(perturbed(grid(1, 1), std::numeric_limits<double>::quiet_NaN(), 1), "perturbed",
                   "amplitude", "nan");
}

TEST(Shuffled, is_the_same_mesh_under_the_numbers_it_returns) {
    for (const Mesh& mesh : {kuhn(1, 9), grid(5, 4), torus(5, 4), bcc(2), kuhn(4, 1)}) {
        const Renumbered result = shuffled(mesh, 3);
        EXPECT_NE(result.mesh.points, mesh.points);
        EXPECT_NE(result.mesh.simplices, mesh.simplices);
        expect_renumbered(result, mesh);
        EXPECT_EQ(shuffled(mesh, 3).mesh.simplices, result.mesh.simplices);
    }
}

/// Mean distance in memory of the vertices of a cell.
double spread(const Mesh& mesh) {
    return (mesh.simplices.rowwise().maxCoeff() - mesh.simplices.rowwise().minCoeff())
        .cast<double>()
        .mean();
}

TEST(MortonCurve, gives_the_same_mesh_under_the_numbers_it_returns) {
    for (const Mesh& mesh : {kuhn(1, 9), grid(5, 4), torus(5, 4), bcc(2), kuhn(4, 1)}) {
        expect_renumbered(along_morton_curve(mesh), mesh);
        EXPECT_TRUE(same_geometry(along_morton_curve(shuffled(mesh, 3).mesh).mesh, mesh));
    }
}

TEST(MortonCurve, brings_neighbors_near_in_memory) {
    for (const Mesh& mesh : {grid(64, 64), kuhn(3, 16), icosphere(20)}) {
        const Mesh disordered = shuffled(mesh, 5).mesh;
        const double vertices = static_cast<double>(mesh.points.rows());
        EXPECT_GT(spread(disordered), 0.3 * vertices);
        EXPECT_LT(spread(along_morton_curve(disordered).mesh), 0.15 * vertices);
    }
}

TEST(MortonCurve, does_not_depend_on_the_numbers_before) {
    const Mesh mesh = bcc(3);
    EXPECT_EQ(along_morton_curve(shuffled(mesh, 1).mesh).mesh.points,
              along_morton_curve(mesh).mesh.points);
    EXPECT_NE(shuffled(mesh, 1).mesh.points, mesh.points);
}

TEST(MortonCurve, passes_through_the_quarters_of_a_square_one_after_the_other) {
    Points corners(4, 2);
    corners << 1, 1, 0, 1, 1, 0, 0, 0;
    EXPECT_EQ(along_morton_curve({corners, Simplices(0, 3), {}}).vertices,
              (std::vector<Index>{3, 2, 1, 0}));
}

TEST(MortonCurve, refuses_what_has_no_place_on_it) {
    Mesh mesh = grid(1, 1);
    mesh.points(2, 1) = std::numeric_limits<double>::infinity();
    EXPECT_REFUSED(along_morton_curve(mesh), "along_morton_curve", "vertex 2", "coordinate",
                   "finite");
}

TEST(Shuffled, tags_follow_their_cells) {
    Mesh mesh = grid(5, 4);
    for (Index cell = 0; cell < mesh.simplices.rows(); ++cell)
        mesh.tags.push_back(100 + cell);
    const Renumbered result = shuffled(mesh, 3);
    EXPECT_NE(result.mesh.tags, mesh.tags);
    for (std::size_t cell = 0; cell < mesh.tags.size(); ++cell)
        EXPECT_EQ(result.mesh.tags[cell], 100 + result.cells[cell]);
    mesh.tags.pop_back();
    EXPECT_REFUSED(shuffled(mesh, 3), "shuffled", "39 tags", "40 cells");
}

TEST(Renumbered, facets_with_tags_follow_their_vertices) {
    Mesh mesh = kuhn(3, 2);
    mesh.facet_tags = {Simplices{{0, 1, 4}, {26, 13, 0}}, {5, 6}};
    for (const auto& result : {shuffled(mesh, 6), along_morton_curve(mesh)}) {
        const auto& [facets, tags] = result.mesh.facet_tags;
        ASSERT_EQ(facets.rows(), 2);
        for (Index i = 0; i < 6; ++i)
            EXPECT_EQ(result.vertices[facets.data()[i]], mesh.facet_tags.simplices.data()[i]);
        EXPECT_EQ(tags, mesh.facet_tags.tags);
        EXPECT_NE(facets, mesh.facet_tags.simplices); // the old numbers would be others
    }
    mesh.facet_tags.tags.pop_back();
    EXPECT_REFUSED(shuffled(mesh, 6), "1 tags", "2 facets");
}

TEST(Shuffled, refuses_a_vertex_number_out_of_range) {
    Mesh mesh = grid(1, 1);
    mesh.simplices(1, 2) = 4;
    EXPECT_REFUSED(shuffled(mesh, 1), "shuffled", "cell 1", "vertex 4", "4 vertices");
}

} // namespace polydec::test::in_rearrange
