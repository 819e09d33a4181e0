// SPDX-License-Identifier: MIT
#include "dec/merging/facet_defects.h"
#include "tests/dec/discretized.h"
#include "tests/support/scales.h"

namespace polydec::test::in_layers {

Index without_dual(const Discretization& mesh) {
    const auto marks = Cells(mesh.complex(), mesh.volumes()).boundary_facets_without_dual();
    return static_cast<Index>(std::count(marks.begin(), marks.end(), true));
}

TEST(Layers, stay_layers_however_thin_they_are) {
    for (const double thickness : {1e-3, 1e-4, 1e-5, 1e-6, 1e-7}) {
        EXPECT_EQ(sizes(discretize(layers(2, 10, thickness)).complex()), sizes_of_boxes(2, 10))
            << thickness;
        if (thickness > 1e-7) {
            EXPECT_EQ(sizes(discretize(layers(3, 4, thickness)).complex()), sizes_of_boxes(3, 4))
                << thickness;
        }
    }
    EXPECT_EQ(sizes(discretize(layers(4, 2, 1e-5)).complex()), sizes_of_boxes(4, 2));
}

TEST(Layers, stay_layers_where_boxes_grow) {
    EXPECT_EQ(sizes(discretize(graded(2, 12, 1e6)).complex()), sizes_of_boxes(2, 12));
    EXPECT_EQ(sizes(discretize(graded(3, 6, 3e4)).complex()), sizes_of_boxes(3, 6));
}

TEST(Layers, stay_layers_when_turned_shuffled_or_given_by_lengths) {
    for (const int n : {2, 3}) {
        const Mesh mesh = layers(n, 4, 1e-5);
        const Mesh turned = transformed(mesh, random_isometry(n, 3));
        EXPECT_EQ(sizes(discretize(turned).complex()), sizes_of_boxes(n, 4));
        EXPECT_EQ(sizes(discretize(shuffled(mesh, 7).mesh).complex()), sizes_of_boxes(n, 4));
    }
    EXPECT_EQ(sizes(discretize(length_mesh(layers(2, 4, 1e-4))).complex()), sizes_of_boxes(2, 4));
}

TEST(Layers, stay_layers_after_flips) {
    const auto mesh = discretize(layers(2, 10, 1e-5), {.delaunay = Delaunay::flips});
    EXPECT_EQ(sizes(mesh.complex()), sizes_of_boxes(2, 10));
    EXPECT_EQ(mesh.degenerate().boundary, 0);
}

TEST(Layers, have_duals_on_their_boundary) {
    for (const int n : {2, 3}) {
        const auto mesh = discretize(layers(n, 4, 1e-5));
        EXPECT_EQ(without_dual(mesh), 0);
        EXPECT_EQ(mesh.degenerate().boundary, 0);
    }
}

TEST(LayersBroken, by_size_of_the_facet_alone_would_be_one) {
    const auto mesh = discretize(layers(2, 10, 1e-6), {.criterion = MergeCriterion::none});
    const auto defects = facet_defects(mesh.input_geometry(), mesh.options());
    Index within = 0, degenerate = 0;
    for (Index e = 0; e < mesh.input().size(1); ++e)
        if (mesh.input().coface_counts(1)[e] == 2) {
            within += defects.ratio(e) <= mesh.options().tolerance;
            degenerate += defects.degenerate[e];
        }
    EXPECT_EQ(degenerate, 100);  // the diagonals
    EXPECT_EQ(within, 100 + 90); // and all between two layers
}

TEST(DegenerateDuals, are_short_against_facet_and_heights) {
    EXPECT_TRUE(is_degenerate(9e-5, 0, 1, 1, 1e-4));
    EXPECT_FALSE(is_degenerate(1.1e-4, 0, 1, 1, 1e-4));
    EXPECT_FALSE(is_degenerate(9e-5, 0, 1, 8e-4, 1e-4));
    EXPECT_TRUE(is_degenerate(-9e-5, 0, 1, 1, 1e-4));
    EXPECT_TRUE(is_degenerate(1e-10, 1e6, 1, 1, 0)); // no more than rounding
    EXPECT_FALSE(is_degenerate(1e-10, 1e5, 1, 1, 0));
    EXPECT_FALSE(is_degenerate(0, 0, 0, 1, 1e-4)); // a vertex has no extent
}

TEST(BoundaryFacets, have_no_dual_opposite_to_a_right_angle) {
    // a square of four triangles: their circumcenters lie on the sides, or beyond
    for (const double jitter : {0.0, 1e-7}) {
        const auto mesh = discretize(made_of({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0.5 + jitter}},
                                             {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}));
        const auto marks = Cells(mesh.complex(), mesh.volumes()).boundary_facets_without_dual();
        for (Index f = 0; f < mesh.complex().size(1); ++f)
            EXPECT_EQ(marks[f], mesh.complex().coface_counts(1)[f] == 1 &&
                                    (jitter == 0 || mesh.volumes().dual(1)[f] < 0));
    }
    for (const Mesh& boxes : {grid(3, 3), kuhn(3, 2), kuhn(1, 4)})
        EXPECT_EQ(without_dual(discretize(boxes)), 0);
}

} // namespace polydec::test::in_layers
