// SPDX-License-Identifier: MIT
#include "backends/mesher/mesher_input.h"

#include "backends/mesher.h"
#include "tests/backends/mesher_support.h"
#include "tests/support/says.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>
#include <numbers>
#include <numeric>

namespace polydec::test::in_mesher_input {
namespace {

// All this is found before the program is run, so it holds where there is none.

TEST_F(MesherTest, coordinates_must_be_finite) {
    auto input = cube();
    input.points(3, 1) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(says(refusal_of(input), {"mesher", "point 3", "(1, nan, 0)"}));
    input = cube();
    input.holes = Points::Constant(1, 3, std::numeric_limits<double>::infinity());
    EXPECT_TRUE(says(refusal_of(input), {"mesher", "hole 0", "(inf, inf, inf)"}));
    EXPECT_TRUE(
        says(refusal_of({.points = Points::Zero(5, 2)}), {"mesher", "point", "2 coordinates"}));
}

TEST_F(MesherTest, holes_are_inside_of_a_surface) {
    auto input = cube(3.0, -1.0);
    input.holes.resize(2, 3);
    input.holes.row(0) << 0.5, 0.25, 0.3;
    const auto refusal = [&](double x, double y, double z) {
        input.holes.row(1) << x, y, z;
        return refusal_of(input);
    };
    const Words on_facet{"mesher", "hole 1", "on a facet"};
    EXPECT_TRUE(says(refusal(0.5, 0.25, 2.0), on_facet));
    EXPECT_TRUE(says(refusal(0.5, 2.0, 2.0), on_facet)) << "on an edge";
    EXPECT_TRUE(says(refusal(2.0, 2.0, 2.0), on_facet)) << "at a corner";
    const Words outside{"mesher", "hole 1", "outside"};
    for (const double far : {2.001, 40.0, 1e300})
        EXPECT_TRUE(says(refusal(0.5, 0.25, far), outside));
    input = cube(1e-200);
    input.holes.resize(2, 3);
    input.holes.row(0).setConstant(5e-201);
    EXPECT_TRUE(says(refusal(0.0, 0.0, 2e-200), outside));
    EXPECT_TRUE(says(refusal(0.0, 5e-201, 5e-201), on_facet));
}

TEST(PlanePatches, take_time_in_proportion_to_the_corners) {
    const auto seconds = [](Index sides) {
        // a prism, whose top and bottom have all corners
        MesherInput input{.points = Points(2 * sides, 3)};
        for (Index i = 0; i < sides; ++i) {
            const double angle = 2 * std::numbers::pi * i / sides;
            input.points.row(i) << std::cos(angle), std::sin(angle), 0.0;
            input.points.row(i + sides) << std::cos(angle), std::sin(angle), 1.0;
        }
        input.corners.resize(static_cast<std::size_t>(2 * sides));
        std::iota(input.corners.begin(), input.corners.end(), Index{0});
        input.offsets = {0, sides, 2 * sides};
        for (Index i = 0; i < sides; ++i) {
            const Index next = (i + 1) % sides;
            input.corners.insert(input.corners.end(), {i, next, next + sides, i + sides});
            input.offsets.push_back(static_cast<Index>(input.corners.size()));
        }
        double least = std::numeric_limits<double>::infinity();
        for (int i = 0; i < 3; ++i) {
            const auto begin = std::clock();
            EXPECT_EQ(plane_patches(input).back(), facet_count(input) - 1);
            least = std::min(least, static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
        }
        return least;
    };
    EXPECT_LT(seconds(16000), 8 * seconds(4000)) << "4 times the corners";
}

TEST_F(MesherTest, surfaces_have_two_sides) {
    // the projective plane on six vertices
    MesherInput input{.points = cloud(6)};
    input.corners = {0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 5, 0, 5, 1,
                     1, 2, 4, 2, 3, 5, 3, 4, 1, 4, 5, 2, 5, 1, 3};
    for (Index i = 0; i <= 30; i += 3)
        input.offsets.push_back(i);
    EXPECT_TRUE(says(refusal_of(input), {"mesher", "one side"}));
}

TEST_F(MesherTest, points_must_span_a_volume) {
    EXPECT_TRUE(says(refusal_of({.points = cloud(3)}), {"mesher", "3 points"}));
    Points points = cloud(20);
    points.col(2) = 0.3 * points.col(0) - 0.7 * points.col(1);
    EXPECT_TRUE(says(refusal_of({.points = points}), {"mesher", "20 points", "plane"}));
    points.col(1) = 0.1 * points.col(0);
    points.col(2) = 0.2 * points.col(0);
    EXPECT_TRUE(says(refusal_of({.points = points}), {"mesher", "20 points", "line"}));
    points = cloud(20);
    points.row(17) = points.row(4);
    EXPECT_TRUE(says(refusal_of({.points = points}), {"mesher", "points 4", "17"}));
}

TEST_F(MesherTest, facets_must_be_plane_polygons) {
    const auto broken = [](std::size_t place, Index corner) {
        auto input = cube();
        input.corners[place] = corner;
        return refusal_of(input);
    };
    EXPECT_TRUE(says(broken(5, 8), {"mesher", "facet 1", "corner 8", "0", "7"}));
    EXPECT_TRUE(says(broken(5, 4), {"mesher", "facet 1 (4 4 7 6)", "corner 4", "twice"}));

    auto input = cube();
    input.offsets[1] = 2;
    EXPECT_TRUE(says(refusal_of(input), {"mesher", "facet 0", "2 corners"}));
    input.offsets[1] = 9;
    EXPECT_TRUE(says(refusal_of(input), {"mesher", "offsets", "facets", "24"}));

    input = cube();
    input.points(7, 2) = 1.25;
    EXPECT_TRUE(
        says(refusal_of(input), {"mesher", "facet 1 (4 5 7 6)", "plane", "corner 5", "0.086"}));
}

TEST_F(MesherTest, facets_must_have_area) {
    MesherInput input;
    input.points.resize(5, 3);
    input.points << 0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 0, 0, 1;
    input.corners = {0, 1, 2, 0, 3, 4};
    input.offsets = {0, 3, 6};
    EXPECT_TRUE(says(refusal_of(input), {"mesher", "facet 0 (0 1 2)", "area"}));
}

TEST_F(MesherTest, a_surface_must_be_closed) {
    auto input = cube();
    input.corners.resize(20);
    input.offsets.resize(6);
    EXPECT_TRUE(says(refusal_of(input), {"mesher", "closed", "4", "edge 1 3", "facet 0", "edge 1 5",
                                         "facet 2", "edge 3 7", "facet 3"}));
}

TEST_F(MesherTest, options_must_make_sense) {
    EXPECT_TRUE(says(refusal_of(cube(), {.quality = 0.5}), {"mesher", "circumradius", "0.5"}));
    EXPECT_TRUE(says(refusal_of(cube(), {.largest_volume = -1.0}), {"mesher", "volume", "-1"}));
    EXPECT_TRUE(says(refusal_of(cube(), {.seconds = 0.0}), {"mesher", "0 seconds"}));
    EXPECT_TRUE(says(message_of<InvalidInput>([] { tetrahedralize(cube(), {}, "netgen"); }),
                     {"mesher", "netgen"}));
}

} // namespace
} // namespace polydec::test::in_mesher_input
