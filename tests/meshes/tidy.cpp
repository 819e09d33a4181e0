// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_tidy {

Mesh make(std::initializer_list<std::initializer_list<double>> points,
          std::initializer_list<std::initializer_list<Index>> cells) {
    return {Points(points), Simplices(cells), {}};
}

/// A square with the corners 0 to 3 and a point 4 above, to which triangles are added.
Mesh square_and(std::initializer_list<std::initializer_list<Index>> cells) {
    Mesh mesh = make({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 2}}, cells);
    return mesh;
}

TEST(Tidy, leaves_clean_meshes_as_they_are) {
    for (const Mesh& mesh :
         {kuhn(1, 3), grid(3, 2), torus(5, 4), goldberg(3), bcc(2), kuhn(5, 1)}) {
        const Mesh result = tidy(mesh);
        EXPECT_EQ(result.points, mesh.points);
        EXPECT_EQ(result.simplices, mesh.simplices);
        EXPECT_TRUE(result.warnings.empty());
    }
}

TEST(Tidy, keeps_earlier_warnings_in_front) {
    Mesh mesh = square_and({{0, 1, 2}, {0, 2, 3}});
    mesh.warnings = {"something was odd"};
    EXPECT_EACH_SAYS(tidy(mesh).warnings, {"something was odd"}, {"1 vertex", "no cell", "4"});
}

TEST(Tidy, leaves_out_cells_with_a_repeated_corner) {
    const Mesh result = tidy(square_and({{0, 0, 1}, {0, 1, 2}, {3, 4, 3}, {0, 2, 3}, {3, 2, 4}}));
    EXPECT_EQ(result.simplices, (Simplices{{0, 1, 2}, {0, 2, 3}, {3, 2, 4}}));
    EXPECT_EACH_SAYS(result.warnings, {"2 cells", "corner", "0 (0 0 1)", "2 (3 4 3)"});
}

TEST(Tidy, tags_follow_the_cells_that_stay) {
    Mesh mesh = square_and({{0, 0, 1}, {0, 1, 2}, {3, 4, 3}, {0, 2, 3}, {2, 1, 0}, {3, 2, 4}});
    mesh.tags = {10, 11, 12, 13, 14, 15};
    EXPECT_EQ(tidy(mesh).tags, (std::vector<Index>{11, 13, 15}));
    mesh.tags.pop_back();
    EXPECT_REFUSED(tidy(mesh), "5 tags", "6 cells");
}

TEST(Tidy, facets_with_tags_stay_and_must_be_facets) {
    Mesh mesh = square_and({{0, 0, 1}, {0, 1, 2}, {3, 4, 3}, {0, 2, 3}});
    mesh.facet_tags = {Simplices{{1, 0}, {2, 0}, {4, 3}}, {5, 6, 7}};
    const Mesh result = tidy(mesh);
    EXPECT_EQ(result.facet_tags.simplices, mesh.facet_tags.simplices);
    EXPECT_EQ(result.facet_tags.tags, mesh.facet_tags.tags);
    mesh.facet_tags.simplices(2, 0) = 5;
    EXPECT_REFUSED(tidy(mesh), "facet 2", "tags", "vertices 5 3", "5");
}

TEST(Tidy, names_five_cells_and_counts_the_others) {
    const Mesh result = tidy(square_and({{1, 1, 1},
                                         {0, 0, 1},
                                         {0, 0, 2},
                                         {0, 0, 3},
                                         {0, 0, 4},
                                         {1, 1, 2},
                                         {1, 1, 3},
                                         {0, 1, 2},
                                         {0, 2, 3},
                                         {3, 2, 4}}));
    EXPECT_EACH_SAYS(result.warnings, {"7 cells", "corner", "0 (1 1 1)", "1 (0 0 1)", "2 (0 0 2)",
                                       "3 (0 0 3)", "4 (0 0 4)", "2 more"});
}

TEST(Tidy, leaves_out_all_but_the_first_cell_on_the_same_vertices) {
    const Mesh result =
        tidy(square_and({{0, 1, 2}, {0, 2, 3}, {1, 2, 0}, {3, 2, 4}, {2, 1, 0}, {4, 3, 2}}));
    EXPECT_EQ(result.simplices, (Simplices{{0, 1, 2}, {0, 2, 3}, {3, 2, 4}}));
    EXPECT_EACH_SAYS(result.warnings,
                     {"3 cells", "vertices", "2 (1 2 0)", "4 (2 1 0)", "5 (4 3 2)"});
}

TEST(Tidy, leaves_out_flat_cells_at_the_boundary) {
    // Vertex 2 lies between 0 and 1, and only one edge of the flat triangle has a neighbor.
    const Mesh result = tidy(make({{0, 0}, {2, 0}, {1, 0}, {1, 1}}, {{0, 1, 3}, {0, 2, 1}}));
    EXPECT_EQ(result.simplices, (Simplices{{0, 1, 3}}));
    EXPECT_EACH_SAYS(result.warnings, {"1 cell", "area", "1 (0 2 1)"},
                     {"1 vertex", "no cell", "2"});
}

TEST(Tidy, leaves_out_a_chain_of_flat_cells_from_its_free_end) {
    // A fan of flat triangles hangs on edge 0 1 of a triangle.
    const Mesh result = tidy(make({{0, 0}, {4, 0}, {2, 2}, {1, 0}, {2, 0}, {3, 0}},
                                  {{0, 3, 4}, {0, 4, 5}, {0, 5, 1}, {0, 1, 2}}));
    EXPECT_EQ(result.simplices, (Simplices{{0, 1, 2}}));
    EXPECT_SAYS(result.warnings.front(), "3 cells", "area", "0 (0 3 4)", "1 (0 4 5)", "2 (0 5 1)");
}

TEST(Tidy, leaves_out_very_many_flat_cells_on_one_edge_in_short_time) {
    const Index count = 100000;
    Mesh mesh{Points::Zero(count + 3, 2), Simplices(count + 1, 3), {}};
    mesh.points.row(1) << count, 0.0;
    mesh.points.row(2) << 0.0, 1.0;
    mesh.simplices.row(0) << 0, 1, 2;
    for (Index i = 0; i < count; ++i) {
        mesh.points.row(i + 3) << i + 0.5, 0.0;
        mesh.simplices.row(i + 1) << 0, 1, i + 3;
    }
    EXPECT_EQ(tidy(mesh).simplices.rows(), 1);
}

TEST(Tidy, works_on_several_flaws_at_once_and_uses_the_numbers_of_the_input) {
    const Mesh result = tidy(make({{9, 9}, {0, 0}, {2, 0}, {1, 0}, {1, 1}, {8, 8}},
                                  {{1, 1, 2}, {1, 2, 4}, {4, 1, 2}, {2, 1, 3}}));
    EXPECT_EQ(result.points.rows(), 6);
    EXPECT_EQ(result.simplices, (Simplices{{1, 2, 4}}));
    EXPECT_EACH_SAYS(result.warnings, {"1 cell", "corner", "0 (1 1 2)"},
                     {"1 cell", "vertices", "2 (4 1 2)"}, {"1 cell", "area", "3 (2 1 3)"},
                     {"3 vertices", "no cell", "0, 3, 5"});
}

TEST(Tidy, refuses_a_flat_cell_between_neighbors_and_names_vertices_to_be_joined) {
    EXPECT_REFUSED(tidy(make({{0, 0}, {1, 0}, {0.5, 1}, {0.5, -1}, {1, 0}},
                             {{0, 1, 2}, {0, 4, 1}, {0, 3, 4}})),
                   "cell 1", "vertices 0 4 1", "area", "vertices 1", "4", "same point", "(1, 0)",
                   "flips");
}

TEST(Tidy, refuses_a_flat_cell_between_neighbors_and_names_the_vertex_on_its_edge) {
    EXPECT_REFUSED(tidy(make({{0, 0}, {2, 0}, {1, 0}, {1, 1}, {0, -1}},
                             {{3, 3, 4}, {0, 1, 3}, {0, 2, 1}, {0, 4, 2}})),
                   "cell 2", "vertices 0 2 1", "area", "vertex 2", "(1, 0)", "edge", "0", "1",
                   "flips");
}

TEST(Tidy, names_further_flat_cells_that_cannot_be_left_out) {
    // A strip of three squares, whose inner vertices on the right fall on those on the left.
    Mesh mesh = grid(1, 3);
    mesh.points(5, 0) = mesh.points(6, 0) = 0.0;
    EXPECT_REFUSED(tidy(mesh), "cell 1", "vertices 1 5 6", "area", "vertices 1", "5", "same point",
                   "(0, 0.3333333333333333)", "3 more", "2 (2 6 7)", "3 (1 0 5)", "4 (2 1 6)");
}

TEST(Tidy, refuses_an_inner_sliver_in_space) {
    // Two tetrahedra on the faces of a flat one: corners 0 to 3 of a square.
    EXPECT_REFUSED(
        tidy(make({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}, {0.5, 0.5, -1}},
                  {{0, 1, 2, 4}, {0, 1, 2, 3}, {0, 1, 3, 5}})),
        "cell 1", "vertices 0 1 2 3", "volume", "plane", "peeled");
}

TEST(Tidy, judges_flatness_by_shape_not_by_size) {
    for (const double scale : {1e-300, 1e-20, 1.0, 1e20, 1e307}) {
        Mesh mesh = perturbed(kuhn(3, 1), 0.1, 5);
        mesh.points *= scale;
        EXPECT_EQ(tidy(mesh).simplices.rows(), 6) << scale;
    }
    const auto needle = [](double height) {
        return make({{0, 0}, {1, 0}, {0.5, height}}, {{0, 1, 2}});
    };
    EXPECT_EQ(tidy(needle(1.01e-12)).simplices.rows(), 1);
    EXPECT_REFUSED(tidy(needle(0.99e-12)), "no cells", "volume", "1 cell", "area", "0 (0 1 2)");
    const double largest = std::numeric_limits<double>::max();
    EXPECT_EQ(tidy(make({{-largest, 0}, {largest, 0}, {0, largest}}, {{0, 1, 2}})).simplices.rows(),
              1);
}

/// Squares of its edges are too small for numbers, or for their inverses.
TEST(Tidy, judges_flatness_at_the_ends_of_the_range_as_at_1) {
    const Mesh sliver = make({{1, -3}, {2, -3 + 0x1p-42}, {2, -3}}, {{0, 1, 2}});
    EXPECT_REFUSED(tidy(sliver), "no cells");
    for (const double scale : {0x1p-498, 0x1p-508, 0x1p-518, 0x1p-528, 0x1p-538, 0x1p500}) {
        Mesh mesh = sliver;
        mesh.points *= scale;
        EXPECT_REFUSED(tidy(mesh), "no cells") << scale;
    }
}

TEST(Tidy, works_for_curves_and_for_points) {
    EXPECT_REFUSED(tidy(make({{0, 0}, {1, 1}, {1, 1}, {2, 0}}, {{0, 1}, {1, 2}, {2, 3}})), "cell 1",
                   "vertices 1 2", "length", "vertices 1", "2", "same point", "(1, 1)");
    EXPECT_SAYS(tidy(make({{0, 0}, {1, 1}, {1, 1}}, {{0, 1}, {1, 2}})).warnings.front(), "1 cell",
                "length", "1 (1 2)");
    EXPECT_EQ(tidy(make({{0.0}, {1.0}}, {{0}, {1}, {0}})).simplices, (Simplices{{0}, {1}}));
}

TEST(Tidy, refuses_what_is_no_mesh) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_REFUSED(tidy(make({{0, 0}, {1, nan}, {0, 1}}, {{0, 1, 2}})), "vertex 1", "finite",
                   "(1, nan)");
    EXPECT_REFUSED(tidy(square_and({{0, 1, 2}, {0, 5, 3}})), "cell 1", "vertices 0 5 3", "5");
    EXPECT_REFUSED(tidy(square_and({{0, 1, -2}})), "cell 0", "vertices 0 1 -2", "5");
    EXPECT_REFUSED(tidy(square_and({{0, 1, 2, 3}})), "dimension 3", "3 coordinates", "2");
    EXPECT_REFUSED(tidy(Mesh{}), "no cells", "volume");
    EXPECT_REFUSED(tidy({Points::Zero(2, 3), Simplices(0, 3), {}}), "no cells", "volume");
    EXPECT_REFUSED(tidy(square_and({{0, 0, 1}, {1, 1, 2}})), "no cells", "volume", "2 cells",
                   "corner", "0 (0 0 1)", "1 (1 1 2)");
}

TEST(Tidy, does_not_depend_on_numbers) {
    Mesh mesh = make({{0, 0}, {4, 0}, {2, 2}, {1, 0}, {2, 0}, {3, 0}},
                     {{0, 3, 4}, {0, 4, 5}, {0, 5, 1}, {0, 1, 2}, {2, 1, 0}, {3, 3, 3}});
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Mesh result = tidy(shuffled(mesh, seed).mesh);
        EXPECT_EQ(result.simplices.rows(), 1);
        EXPECT_EQ(result.warnings.size(), 4U);
    }
}

} // namespace polydec::test::in_tidy
