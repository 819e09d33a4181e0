// SPDX-License-Identifier: MIT
#include "complex/surfaces/ordered_surface.h"
#include "meshes/generate.h"
#include "shape/bisection.h"
#include "shape/shape_spectrum.h"
#include "tests/shape/known_shapes.h"
#include "tests/support/glued.h"
#include "tests/support/refusal.h"
#include "tests/support/says.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace polydec::test::in_refinement {
namespace {

std::vector<Index> some(std::mt19937& random, Index size) {
    std::vector<Index> chosen;
    for (Index t = 0; t < size; ++t)
        if (random() % 3 == 0)
            chosen.push_back(t);
    return chosen;
}

/// Eigenvalues are those of the shape, so the parts enclose them as well: also with conditions,
/// weights and branching edges.
TEST(Bisection, changes_the_mesh_and_not_the_shape) {
    std::mt19937 random(11);
    for (int i = 0; i < 30; ++i) {
        KnownShape known = random_shape(random);
        if (known.shape.pieces.dimension() != 2)
            continue;
        const Index zeros = zero_eigenvalues(known.shape);
        for (int step = 0; step < 2; ++step)
            known.shape = bisected(known.shape, some(random, known.shape.pieces.size(2)));
        EXPECT_EQ(zero_eigenvalues(known.shape), zeros);
        const auto found = shape_spectrum(known.shape, {.count = 4});
        for (Index j = 0; j < 4; ++j) {
            EXPECT_LE(found.lower[j], known.eigenvalues[j] * (1 + 1e-12)) << known.name << i;
            EXPECT_GE(found.upper[j], known.eigenvalues[j] * (1 - 1e-12)) << known.name << i;
        }
    }
}

double area(const Shape& shape) {
    double sum = 0;
    for (Index t = 0; t < shape.pieces.size(2); ++t) {
        const auto l = [&](int i) { return shape.lengths[shape.pieces.face(2, t, i)]; };
        const double s = (l(0) + l(1) + l(2)) / 2;
        sum += std::sqrt(s * (s - l(0)) * (s - l(1)) * (s - l(2)));
    }
    return sum;
}

TEST(Bisection, of_triangles_glued_to_themselves_keeps_area_and_topology) {
    for (const auto& surface : {square_torus(), square_klein(), two_sided_plane(),
                                folded_triangle(), moebius_triangle()}) {
        std::vector<Index> names(surface.vertices());
        std::iota(names.begin(), names.end(), Index{0});
        Shape shape{in_order(surface, names).pieces, Vector::Ones(surface.edges())};
        const double whole = area(shape);
        const Index characteristic = euler_characteristic(shape.pieces);
        const bool is_orientable = shape.pieces.orientable();
        for (int step = 0; step < 4; ++step) {
            std::vector<Index> all(shape.pieces.size(2));
            std::iota(all.begin(), all.end(), Index{0});
            shape = bisected(shape, all);
            EXPECT_NEAR(area(shape), whole, 1e-12);
            EXPECT_EQ(euler_characteristic(shape.pieces), characteristic);
            EXPECT_EQ(shape.pieces.orientable(), is_orientable);
        }
        EXPECT_GE(shape.pieces.size(2), 16);
    }
}

/// Order N^-2 in the number of triangles, in spite of the corner.
TEST(Adaptive, enclosures_of_an_l_have_order_4) {
    const Shape shape = unmerged(l_shape(2), {BoundaryCondition::essential});
    const double truth = 9.6397238440219;
    std::vector<double> wide, triangles;
    for (const double width : {1e-2, 1e-4}) {
        const auto found =
            shape_spectrum(shape, {.count = 1, .width = width, .max_triangles = 9000});
        EXPECT_LE(found.lower[0], truth);
        EXPECT_GE(found.upper[0], truth);
        EXPECT_LE(widths(found)[0], width);
        EXPECT_TRUE(found.warnings.empty());
        EXPECT_EQ(found.modes.rows(), shape.pieces.size(0));
        wide.push_back(widths(found)[0]);
        triangles.push_back(found.simplices);
    }
    EXPECT_GE(std::log(wide[0] / wide[1]) / std::log(triangles[1] / triangles[0]), 1.7);
    EXPECT_LE(triangles[1], 1800);
}

TEST(Adaptive, enclosures_of_a_cube_take_few_triangles) {
    const auto found = shape_spectrum(unmerged(cube_surface(2)),
                                      {.count = 4, .width = 1e-4, .max_triangles = 4000});
    EXPECT_LE(widths(found).maxCoeff(), 1e-4);
    EXPECT_LE(found.simplices, 2000);
    EXPECT_LE(found.lower[3], 4.1661180);
    EXPECT_GE(found.upper[1], 4.1660445);
}

TEST(Adaptive, stops_at_the_most_triangles_with_a_warning) {
    const auto found = shape_spectrum(unmerged(cube_surface(2)),
                                      {.count = 4, .width = 1e-9, .max_triangles = 200});
    EXPECT_GE(found.simplices, 200);
    EXPECT_LE(found.simplices, 1000);
    ASSERT_FALSE(found.warnings.empty());
    EXPECT_TRUE(says(found.warnings.back(), {"3 of 4", "1e-09", "refine"}));
    EXPECT_TRUE(says(refusal([&] {
                         shape_spectrum(unmerged(cube_surface(2)),
                                        {.level = 1, .max_triangles = 9});
                     }),
                     {"9", "level 2"}));
    EXPECT_TRUE(says(refusal([&] { bisected(unmerged(kuhn(3, 1)), {0}); }), {"3", "surface"}));
}

} // namespace
} // namespace polydec::test::in_refinement
