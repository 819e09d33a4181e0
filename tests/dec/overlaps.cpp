// SPDX-License-Identifier: MIT
#include "dec/metric/overlaps.h"

#include "tests/support/test.h"

namespace polydec::test::in_overlaps {

using Cells = std::vector<Index>;

Overlaps overlaps(const Mesh& mesh) {
    const SimplicialComplex complex(mesh.simplices);
    return find_overlaps(complex, vertex_points(complex, mesh.points));
}

class Overlapping : public OverMeshes {};

TEST_P(Overlapping, no_mesh_of_the_family_does) {
    const auto found = overlaps(mesh_named(GetParam()));
    EXPECT_EQ(found.folded, Cells{});
    EXPECT_EQ(found.wound, Cells{});
}

POLYDEC_OVER_MESHES(Overlapping);

/// n-cubes, two on a side, with the vertex in the middle drawn out of them.
Mesh turned_inside_out(int n) {
    Mesh mesh = kuhn(n, 2);
    Vector middle = Vector::Constant(n, 0.5);
    for (Index v = 0; v < mesh.points.rows(); ++v)
        if ((mesh.points.row(v).transpose() - middle).norm() < 1e-9)
            for (int axis = 0; axis < n; ++axis)
                mesh.points(v, axis) += 0.9 + 0.01 * axis;
    return mesh;
}

/// Cells whose determinant has the other sign than those of most.
Cells by_determinant(const SimplicialComplex& K, const Points& points) {
    const int n = K.dimension();
    Cells positive, negative;
    for (Index t = 0; t < K.size(n); ++t) {
        DenseMatrix edges(n, n);
        for (int i = 0; i < n; ++i)
            edges.row(i) = points.row(K.simplices(n)(t, i + 1)) - points.row(K.simplices(n)(t, 0));
        (edges.determinant() * K.orientation(t) > 0 ? positive : negative).push_back(t);
    }
    return positive.size() < negative.size() ? positive : negative;
}

class Folds : public testing::TestWithParam<int> {};

TEST_P(Folds, are_the_cells_that_a_moved_vertex_turns_over) {
    const Mesh mesh = turned_inside_out(GetParam());
    const auto expected = by_determinant(SimplicialComplex(mesh.simplices), mesh.points);
    ASSERT_FALSE(expected.empty());
    for (const double size : {1.0, 1e-150, 1e150}) {
        Mesh scaled = mesh;
        scaled.points *= size;
        const auto found = overlaps(scaled);
        EXPECT_EQ(found.folded, expected);
        EXPECT_EQ(found.wound, Cells{});
    }
    EXPECT_TRUE(overlaps(kuhn(GetParam(), 2)).folded.empty()) << "before it was moved";
}

TEST_P(Folds, do_not_depend_on_the_order_of_cells_and_corners) {
    const Mesh mesh = turned_inside_out(GetParam());
    Mesh other = mesh;
    for (Index t = 0; t < mesh.simplices.rows(); ++t) {
        other.simplices.row(t) = mesh.simplices.row(mesh.simplices.rows() - 1 - t);
        if (t % 3 == 0)
            other.simplices.row(t).reverseInPlace();
    }
    EXPECT_EQ(overlaps(other).folded, overlaps(mesh).folded);
}

INSTANTIATE_TEST_SUITE_P(Dimensions, Folds, testing::Values(1, 2, 3, 4, 5));

/// Simplices around the origin in R^n, n >= 2: a circle of `corners` points that is run through
/// `turns` times, joined with the origin and with the unit points of the other axes, both ways.
Mesh winding(int n, int corners, int turns) {
    const int others = n - 2, ring = corners * turns;
    Mesh mesh{Points::Zero(1 + ring + 2 * others, n), Simplices(ring << others, n + 1), {}};
    for (int i = 0; i < ring; ++i) {
        mesh.points(1 + i, 0) = std::cos(2 * std::numbers::pi * i / corners);
        mesh.points(1 + i, 1) = std::sin(2 * std::numbers::pi * i / corners);
    }
    for (int axis = 0; axis < others; ++axis) {
        mesh.points(1 + ring + 2 * axis, 2 + axis) = 1;
        mesh.points(2 + ring + 2 * axis, 2 + axis) = -1;
    }
    Index row = 0;
    for (int i = 0; i < ring; ++i)
        for (int side = 0; side < 1 << others; ++side, ++row) {
            mesh.simplices.row(row).head(3) << 0, 1 + i, 1 + (i + 1) % ring;
            for (int axis = 0; axis < others; ++axis)
                mesh.simplices(row, 3 + axis) = 1 + ring + 2 * axis + (side >> axis & 1);
        }
    return mesh;
}

class Windings : public testing::TestWithParam<int> {};

TEST_P(Windings, are_found_around_inner_vertices_where_nothing_is_folded) {
    const int n = GetParam();
    for (const int turns : {2, 3}) {
        const auto found = overlaps(winding(n, 5, turns));
        EXPECT_EQ(found.folded, Cells{});
        ASSERT_FALSE(found.wound.empty());
        EXPECT_EQ(found.wound.front(), 0);
    }
    const auto once = overlaps(winding(n, 5, 1));
    EXPECT_EQ(once.folded, Cells{});
    EXPECT_EQ(once.wound, Cells{}) << "wound once";
}

INSTANTIATE_TEST_SUITE_P(Dimensions, Windings, testing::Values(2, 3, 4, 5));

TEST(Overlapping, of_a_spiral_is_seen_on_its_boundary) {
    Mesh mesh{Points::Zero(10, 2), Simplices(8, 3), {}}; // a bit more than one turn
    for (int i = 0; i < 9; ++i)
        mesh.points.row(1 + i) << std::cos(1 + 0.8 * i), std::sin(1 + 0.8 * i);
    for (int i = 0; i < 8; ++i)
        mesh.simplices.row(i) << 0, 1 + i, 2 + i;
    EXPECT_EQ(overlaps(mesh).wound, Cells{0});
    mesh.simplices.conservativeResize(5, 3); // less than one
    EXPECT_EQ(overlaps(mesh).wound, Cells{});
}

TEST(Overlapping, of_a_path_that_turns_back_is_a_fold) {
    EXPECT_EQ(overlaps(made_of({{0}, {1}, {0.5}}, {{0, 1}, {1, 2}})).folded, Cells{1});
    EXPECT_EQ(overlaps(made_of({{0}, {1}, {1.5}}, {{0, 1}, {1, 2}})).folded, Cells{});
}

TEST(Overlapping, of_three_triangles_at_one_edge_of_the_plane_cannot_be_avoided) {
    const auto mesh =
        made_of({{0, 0}, {1, 0}, {0.5, 1}, {0.5, -1}, {0.5, 2}}, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}});
    EXPECT_EQ(overlaps(mesh).folded, Cells{2});
}

/// Around a one-sided band no cell is on a side of its own; one facet is folded all the same.
TEST(Overlapping, of_a_one_sided_band_is_told_at_its_facet) {
    const auto mesh = made_of({{-8, 6}, {-8, -9}, {9, 4}, {-6, 4}, {7, 5}},
                              {{4, 1, 3}, {1, 3, 0}, {3, 0, 2}, {0, 2, 4}, {2, 4, 1}});
    EXPECT_EQ(overlaps(mesh).folded.size(), 1U);
}

TEST(Overlapping, is_asked_of_flat_meshes_in_space_and_of_no_surfaces) {
    const auto expected = overlaps(turned_inside_out(2)).folded;
    EXPECT_FALSE(expected.empty());
    Mesh mesh = turned_inside_out(2);
    mesh.points.conservativeResize(Eigen::NoChange, 3);
    mesh.points.col(2).setConstant(-3.5); // as files with three coordinates have it
    EXPECT_EQ(overlaps(mesh).folded, expected);
    mesh.points(0, 2) += 1e-9;
    EXPECT_EQ(overlaps(mesh).folded, Cells{});
}

TEST(Overlapping, is_not_concluded_from_a_cell_that_is_flat_but_for_rounding) {
    // 0.1 + 0.2 is 0.3 but for the last digit, on one side or the other
    const double above = 0.1 + 0.2, below = 2 * 0.3 - above;
    for (const double height : {above, below})
        EXPECT_EQ(overlaps(made_of({{0, 0.3}, {1, 0.3}, {0.5, height}, {0.5, 1}, {0.5, -1}},
                                   {{0, 1, 2}, {0, 2, 3}, {2, 1, 3}, {1, 0, 4}}))
                      .folded,
                  Cells{});
}

TEST(Overlapping, is_looked_for_between_points_of_all_vertices) {
    const Mesh mesh = grid(2, 2);
    const SimplicialComplex K(mesh.simplices);
    EXPECT_REFUSED(find_overlaps(K, mesh.points.topRows(8)), "8 points", "9");
}

TEST(Discretize, tells_of_folds_and_windings) {
    Mesh mesh = grid(2, 2);
    mesh.points.row(4) << 0.9, 1.3;
    const auto folded = circumcentric(mesh).warnings();
    ASSERT_EQ(folded.size(), 1U);
    EXPECT_SAYS(folded[0], "folded", "1 of 8 cells");
    EXPECT_EACH_SAYS(discretize(winding(2, 5, 2)).warnings(), {"overlaps", "1 vertex", "vertex 0"},
                     {"5 vertices", "coincide"});
    EXPECT_EACH_SAYS(discretize(made_of({{0}, {1}, {0.5}}, {{0, 1}, {1, 2}})).warnings(),
                     {"folded", "1 of 2 cells", "vertices 1 2"});
}

} // namespace polydec::test::in_overlaps
