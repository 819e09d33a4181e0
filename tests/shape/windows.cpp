// SPDX-License-Identifier: MIT
//
// That windows do not grow too many, and that distances are refused where they do.
#include "shape/windows.h"

#include "tests/shape/shapes.h"

namespace polydec::test::in_windows {

WindowDistances windows(const MeasuredSurface& shape, std::size_t most, Index source = 0) {
    const UnfoldedTriangles unfolded(shape.surface, shape.lengths);
    return distances_by_windows(unfolded, std::vector<Index>{source}, most);
}

double windows_of_a_triangle(const MeasuredSurface& shape, Index source = 0) {
    const Index triangles = shape.surface.triangles();
    return double(windows(shape, most_windows(triangles), source).windows) / triangles;
}

TEST(Windows, of_each_triangle_grow_with_the_root_of_the_number_of_triangles) {
    const double coarse = windows_of_a_triangle(measured(icosphere(10)));
    const double fine = windows_of_a_triangle(measured(icosphere(20)));
    EXPECT_LT(fine, 40);
    EXPECT_LT(fine, 2.5 * coarse);
    EXPECT_LT(windows_of_a_triangle(measured(perturbed(torus(60, 30), 0.02, 1))), 40);
    EXPECT_LT(windows_of_a_triangle(measured(perturbed(torus(60, 30), 0.1, 1))), 80);
}

/// Where many equal ways lead up a flight of stairs, one counts.
TEST(Windows, that_reach_the_same_on_equal_ways_are_one) {
    const double coarse = windows_of_a_triangle(measured(walls_of_cubes(4)));
    const double fine = windows_of_a_triangle(measured(walls_of_cubes(8)));
    EXPECT_LT(coarse, 60);
    EXPECT_LT(fine, 2.5 * coarse);
}

TEST(Windows, turn_around_a_sharp_tip_once) {
    for (const double angle : {1e-1, 1e-3, 1e-7})
        for (const Index source : {1, 7, 13})
            EXPECT_LT(windows_of_a_triangle(cone(angle, 5, 4), source), 15) << angle;
}

TEST(Windows, begin_once_at_a_source_that_is_given_twice) {
    const MeasuredSurface sphere = measured(icosphere(4));
    const UnfoldedTriangles unfolded(sphere.surface, sphere.lengths);
    const auto of = [&](std::vector<Index> sources) {
        return distances_by_windows(unfolded, sources, most_windows(320)).windows;
    };
    EXPECT_EQ(of({3, 9, 3}), of({3, 9}));
}

TEST(Windows, end_with_what_the_listener_throws) {
    const MeasuredSurface sphere = measured(icosphere(4));
    const std::vector<Index> sources{0};
    std::vector<std::string> heard;
    const Progress stop = [&](std::string_view what) {
        heard.emplace_back(what);
        throw std::runtime_error("enough");
    };
    EXPECT_THROW(exact_distance(sphere.surface, sphere.lengths, sources, stop), std::runtime_error);
    EXPECT_THROW(ShortestPaths(sphere.surface, sphere.lengths, sources, stop), std::runtime_error);
    EXPECT_THROW(GeodesicDistance(sphere.surface, sphere.lengths, {.progress = stop}).to(sources),
                 std::runtime_error);
    EXPECT_EQ(heard, std::vector<std::string>(3, "0 windows"));
}

TEST(Windows, beyond_the_most_are_refused) {
    const MeasuredSurface sphere = measured(icosphere(4));
    const std::size_t needed = windows(sphere, most_windows(320)).windows;
    EXPECT_EQ(message_of<SolverFailure>([&] { windows(sphere, needed); }), "accepted");
    EXPECT_ERROR(SolverFailure, windows(sphere, needed - 1), std::to_string(needed - 1), "windows",
                 "320 triangles", "delaunay", "heat");
}

} // namespace polydec::test::in_windows
