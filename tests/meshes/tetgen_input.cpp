// SPDX-License-Identifier: MIT
#include "meshes/tetgen/tetgen_input.h"

#include "tests/meshes/tetgen_support.h"

namespace polydec::test::in_tetgen_input {

// All this is found before the program is run, so it holds where there is none.

TEST_F(TetgenTest, coordinates_must_be_finite) {
    auto surface = cube();
    surface.points(3, 1) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_SAYS(refusal_of(surface), "mesher", "point 3", "(1, nan, 0)");
    const Points far = Points::Constant(1, 3, std::numeric_limits<double>::infinity());
    EXPECT_SAYS(refusal_of(cube(), {}, far), "mesher", "hole 0", "(inf, inf, inf)");
    EXPECT_SAYS(refusal_of(cube(), {}, Points::Zero(5, 2)), "hole", "2 coordinates");
}

TEST_F(TetgenTest, holes_are_inside_of_a_surface) {
    auto surface = cube(3.0, -1.0);
    Points holes(2, 3);
    holes.row(0) << 0.5, 0.25, 0.3;
    const auto refusal = [&](double x, double y, double z) {
        holes.row(1) << x, y, z;
        return refusal_of(surface, {}, holes);
    };
    const Words on_facet{"mesher", "hole 1", "on a facet"};
    EXPECT_TRUE(says(refusal(0.5, 0.25, 2.0), on_facet));
    EXPECT_TRUE(says(refusal(0.5, 2.0, 2.0), on_facet)) << "on an edge";
    EXPECT_TRUE(says(refusal(2.0, 2.0, 2.0), on_facet)) << "at a corner";
    const Words outside{"mesher", "hole 1", "outside"};
    for (const double far : {2.001, 40.0, 1e300})
        EXPECT_TRUE(says(refusal(0.5, far, far), outside));
    surface = cube(1e-200);
    holes.row(0).setConstant(5e-201);
    EXPECT_TRUE(says(refusal(0.0, 0.0, 2e-200), outside));
    EXPECT_TRUE(says(refusal(0.0, 5e-201, 5e-201), on_facet));
}

TEST(TetgenInput, triangles_in_one_plane_that_meet_at_edges_are_a_patch) {
    const auto input = tetgen_input(united(cube(), cube(1.0, 3.0)), Points(0, 3));
    for (std::size_t f = 0; f < input.patches.size(); ++f)
        EXPECT_EQ(input.patches[f], static_cast<Index>(f - f % 2)) << "two triangles a side";

    auto bent = cube();
    bent.points(7, 2) += 1e-7;
    EXPECT_EQ(tetgen_input(bent, Points(0, 3)).patches[3], 3);
    bent.points(7, 2) = 1 + 1e-9;
    EXPECT_EQ(tetgen_input(bent, Points(0, 3)).patches[3], 2);
}

TEST_F(TetgenTest, surfaces_have_two_sides) {
    // the projective plane on six vertices
    Mesh surface = icosphere(1);
    surface.points = Points(surface.points.topRows(6));
    surface.simplices.resize(10, 3);
    surface.simplices << 0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 0, 5, 1, 1, 2, 4, 2, 3, 5, 3, 4, 1, 4,
        5, 2, 5, 1, 3;
    EXPECT_SAYS(refusal_of(surface), "mesher", "facet", "one side");
}

TEST_F(TetgenTest, points_must_span_a_volume) {
    Mesh flat = grid(3, 2);
    flat.points.conservativeResize(Eigen::NoChange, 3);
    flat.points.col(2) = 0.3 * flat.points.col(0) - 0.7 * flat.points.col(1);
    EXPECT_SAYS(refusal_of(flat), "mesher", "12 points", "plane");
    flat.simplices = Simplices(flat.simplices.topRows(1));
    EXPECT_SAYS(refusal_of(flat), "mesher", "3 points", "four");
    auto twins = cube();
    twins.points.row(7) = twins.points.row(4);
    EXPECT_SAYS(refusal_of(twins), "mesher", "points 4", "7");
}

TEST_F(TetgenTest, facets_must_be_triangles_with_area) {
    const auto broken = [](Index corner) {
        auto surface = cube();
        surface.simplices(2, 1) = corner;
        return refusal_of(surface);
    };
    EXPECT_SAYS(broken(8), "mesher", "facet 2", "corner 8", "0", "7");
    EXPECT_SAYS(broken(-1), "mesher", "facet 2", "corner -1", "0", "7");
    EXPECT_SAYS(broken(4), "mesher", "facet 2 (4 4 7)", "corner 4", "twice");

    auto thin = cube();
    thin.points.row(3) << 0, 0.5, 0;
    EXPECT_SAYS(refusal_of(thin), "mesher", "facet 0 (0 2 3)", "area");
}

TEST_F(TetgenTest, options_must_make_sense) {
    EXPECT_SAYS(refusal_of(cube(), {.quality = 0.5}), "mesher", "0.5", "circumradius");
    EXPECT_SAYS(refusal_of(cube(), {.largest_volume = -1.0}), "mesher", "volume", "-1");
    EXPECT_SAYS(refusal_of(cube(), {.seconds = 0.0}), "mesher", "0 seconds");
}

} // namespace polydec::test::in_tetgen_input
