// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_glued_surface {

using Betti = std::vector<Index>;
using Triangles = std::vector<std::array<GluedSurface::SignedEdge, 3>>;

Betti betti(const GluedSurface& surface) {
    return betti_numbers(cell_complex(surface));
}

void expect_valid(const GluedSurface& surface) {
    for (Index e = 0; e < surface.edges(); ++e) {
        const auto [h, g] = surface.halfedges(e);
        ASSERT_EQ(surface.edge(h), e);
        if (g < 0)
            continue;
        ASSERT_EQ(surface.edge(g), e);
        ASSERT_NE(h, g);
        const bool coherent = surface.is_coherent(e);
        EXPECT_EQ(surface.tail(h), coherent ? surface.head(g) : surface.tail(g)) << "edge " << e;
        EXPECT_EQ(surface.head(h), coherent ? surface.tail(g) : surface.head(g)) << "edge " << e;
    }
}

void expect_surface(const GluedSurface& surface, const Betti& expected) {
    expect_valid(surface);
    EXPECT_EQ(betti(surface), expected);
    const CellComplex cells = cell_complex(surface);
    EXPECT_TRUE(is_zero(integers(cells.coboundary(1)) * integers(cells.coboundary(0))));
}

class GluedSurfaces : public OverMeshes {};

TEST_P(GluedSurfaces, keep_the_boundary_matrices_of_simplices) {
    const auto& K = mesh().K();
    const CellComplex glued = cell_complex(GluedSurface(K));
    for (int k = 0; k < 2; ++k) {
        EXPECT_TRUE(equal(integers(glued.coboundary(k)), integers(K.coboundary(k))));
        EXPECT_EQ(glued.coface_counts(k), K.coface_counts(k));
    }
}

TEST_P(GluedSurfaces, stay_surfaces_with_the_same_topology_under_any_flips) {
    const auto& K = mesh().K();
    GluedSurface surface(K);
    flip_at_random(surface, 1);
    expect_surface(surface, betti_numbers(K));
}

TEST_P(GluedSurfaces, stay_surfaces_with_the_same_topology_when_the_boundary_is_split) {
    const auto& K = mesh().K();
    GluedSurface surface(K);
    for (Index e = 0; e < K.size(1); ++e)
        if (surface.is_boundary(e))
            surface.split_boundary(e);
    expect_surface(surface, betti_numbers(K));
}

TEST_P(GluedSurfaces, turning_all_triangles_turns_the_signs_of_d_1) {
    GluedSurface surface(mesh().K());
    const auto before = integers(cell_complex(surface).coboundary(1));
    for (Index t = 0; t < surface.triangles(); ++t)
        surface.reverse(t);
    expect_valid(surface);
    EXPECT_TRUE(equal(integers(cell_complex(surface).coboundary(1)), -before));
}

TEST_P(GluedSurfaces, strands_are_the_edges_one_began_with) {
    const auto& K = mesh().K();
    GluedSurface surface(K);
    NormalCoordinates coordinates(surface);
    flip_at_random(surface, 2, [&](Index e) { coordinates.flip(surface, e); });

    // flips at random may wind a strand into a loop or around a handle, but each keeps its ends
    std::vector<std::pair<Index, Index>> found, expected;
    const Strands strands = trace(surface, coordinates);
    for (const auto& [from, to] : strands.ends)
        found.emplace_back(surface.tail(from), surface.tail(to));
    for (Index e = 0; e < surface.edges(); ++e)
        if (coordinates.is_strand(e))
            found.emplace_back(std::minmax(surface.first_vertex(e), surface.last_vertex(e)));
    for (Index e = 0; e < K.size(1); ++e) {
        const auto ends = IncidenceMatrix::InnerIterator(K.coboundary(0), e);
        expected.emplace_back(static_cast<Index>(ends.col()), 0);
        expected.back().second = K.coboundary(0).innerIndexPtr()[2 * e + 1];
    }
    std::sort(found.begin(), found.end());
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(found, expected);
}

INSTANTIATE_TEST_SUITE_P(Family, GluedSurfaces, testing::ValuesIn(names_of_surfaces()),
                         parameter_name);

TEST(GluedTriangles, make_surfaces_that_no_simplicial_complex_of_so_few_can_be) {
    EXPECT_EQ(square_torus().vertices(), 1);
    EXPECT_EQ(betti(square_torus()), (Betti{1, 2, 1}));
    EXPECT_EQ(betti(square_klein()), (Betti{1, 1, 0}));
    EXPECT_EQ(betti(two_sided_plane()), (Betti{1, 0, 0}));
    EXPECT_EQ(betti(folded_triangle()), (Betti{1, 0, 0}));
    EXPECT_EQ(betti(moebius_triangle()), (Betti{1, 1, 0}));
}

TEST(GluedTriangles, have_coefficients_0_where_glued_to_themselves_and_2_if_one_sided) {
    EXPECT_EQ(cell_complex(folded_triangle()).coboundary(1).coeff(0, 0), 0);
    EXPECT_EQ(cell_complex(moebius_triangle()).coboundary(1).coeff(0, 0), 2);
    EXPECT_EQ(cell_complex(moebius_triangle()).coface_counts(1)[0], 2);
}

TEST(GluedTriangles, keep_their_topology_under_flips) {
    for (const auto& make : {square_torus, square_klein, two_sided_plane}) {
        GluedSurface surface = make();
        const auto before = betti(surface);
        flip_at_random(surface, 3);
        expect_surface(surface, before);
    }
}

TEST(GluedTriangles, cannot_flip_an_edge_with_one_triangle) {
    EXPECT_FALSE(folded_triangle().can_flip(0));
    EXPECT_FALSE(folded_triangle().can_flip(1));
    EXPECT_TRUE(square_torus().can_flip(2));
}

TEST(GluedTriangles, four_flips_of_one_edge_lead_back) {
    GluedSurface surface(merged("icosphere3").K());
    NormalCoordinates coordinates(surface);
    const auto before = integers(cell_complex(surface).coboundary(0));
    for (int turn = 1; turn <= 4; ++turn) {
        coordinates.flip(surface, 5);
        surface.flip(5);
        EXPECT_EQ(coordinates.crossings(5), turn % 2);
        EXPECT_EQ(coordinates.is_strand(5), turn % 2 == 0);
    }
    EXPECT_TRUE(equal(integers(cell_complex(surface).coboundary(0)), before));
}

TEST(GluedTriangles, without_being_told_of_a_flip_coordinates_lose_strands) {
    const auto& K = merged("icosphere3").K();
    GluedSurface surface(K);
    NormalCoordinates coordinates(surface);
    coordinates.flip(surface, 5);
    surface.flip(5);
    EXPECT_EQ(trace(surface, coordinates).ends.size(), 1u);
    const NormalCoordinates ignorant(surface);
    EXPECT_TRUE(trace(surface, ignorant).ends.empty());
}

TEST(GluedTriangles, are_refused_by_number) {
    EXPECT_REFUSED(GluedSurface(Triangles{{{{0, 1}, {1, 1}, {2, 1}}}, {{{0, 1}, {0, 1}, {3, 1}}}}),
                   "triangles", "edge 0", "0, 1 and 1");
    EXPECT_REFUSED(GluedSurface(Triangles{{{{0, 1}, {2, 1}, {2, 1}}}}), "no triangle", "edge 1");
    EXPECT_REFUSED(GluedSurface(Triangles{{{{0, 1}, {1, 3}, {2, 1}}}}), "triangle 0", "edge 1",
                   "sign 3");
    EXPECT_REFUSED(GluedSurface(merged("kuhn3").K()), "dimension 3", "surface");
    EXPECT_REFUSED(GluedSurface(merged("branching").K()), "3 triangles", "edge", "vertex 0", "1");
}

} // namespace polydec::test::in_glued_surface
