// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_topology {

struct Shape {
    std::string name;
    std::vector<Index> betti;
    bool orientable;
    Index boundary_components;
};

void PrintTo(const Shape& shape, std::ostream* out) {
    *out << shape.name;
}

class Shapes : public testing::TestWithParam<Shape> {
protected:
    const Merged& mesh() const { return merged(GetParam().name); }
};

TEST_P(Shapes, have_the_numbers_of_topology) {
    EXPECT_EQ(mesh().K().orientable(), GetParam().orientable);
    for (const auto& [name, complex, volumes] : both(mesh())) {
        EXPECT_EQ(betti_numbers(complex), GetParam().betti) << name;
        EXPECT_EQ(components(complex).count, GetParam().betti[0]) << name;
        EXPECT_EQ(boundary_components(complex).count, GetParam().boundary_components) << name;
    }
}

TEST_P(Shapes, merging_keeps_the_boundary) {
    const auto K = boundary_cells(mesh().K()), P = boundary_cells(mesh().P());
    for (int k = 0; k <= mesh().n(); ++k)
        for (Index s = 0; s < mesh().K().size(k); ++s) {
            const auto& carrier = mesh().merging().carriers(k)[s];
            EXPECT_EQ(K[k][s], P[carrier.dimension][carrier.cell]) << "degree " << k;
        }
}

INSTANTIATE_TEST_SUITE_P(
    Known, Shapes,
    testing::Values(
        Shape{"kuhn1d", {1, 0}, true, 2}, Shape{"polygon_curve", {1, 1}, true, 0},
        Shape{"theta_graph", {1, 2}, true, 0}, Shape{"grid4", {1, 0, 0}, true, 1},
        Shape{"ring6", {1, 1, 0}, true, 2}, Shape{"annulus9", {1, 1, 0}, true, 2},
        Shape{"spike", {1, 0, 1}, true, 0}, Shape{"uv8", {1, 0, 1}, true, 0},
        Shape{"icosphere3", {1, 0, 1}, true, 0}, Shape{"goldberg2", {1, 0, 1}, true, 0},
        Shape{"torus8x6", {1, 2, 1}, true, 0}, Shape{"flange8", {1, 2, 1}, true, 0},
        Shape{"clifford_torus", {1, 2, 1}, true, 0}, Shape{"genus_two", {1, 4, 1}, true, 0},
        Shape{"moebius12x2", {1, 1, 0}, false, 1}, Shape{"projective_plane", {1, 0, 0}, false, 0},
        Shape{"klein_bottle", {1, 1, 0}, false, 0}, Shape{"branching", {1, 0, 0}, true, 1},
        Shape{"two_components", {2, 2, 2}, true, 0}, Shape{"triangle_soup", {8, 0, 0}, true, 8},
        Shape{"kuhn3", {1, 0, 0, 0}, true, 1}, Shape{"solid_torus3", {1, 1, 0, 0}, true, 1},
        Shape{"hollow_cube", {1, 0, 1, 0}, true, 2}, Shape{"pinched", {1, 0, 0, 0}, true, 1},
        Shape{"tilted_tetrahedra", {1, 0, 0, 0}, true, 1},
        Shape{"boundary_of_4_simplex", {1, 0, 0, 1}, true, 0},
        Shape{"boundary_of_tesseract", {1, 0, 0, 1}, true, 0},
        Shape{"cubical_torus3", {1, 3, 3, 1}, true, 0}, Shape{"kuhn4", {1, 0, 0, 0, 0}, true, 1},
        Shape{"kuhn5", {1, 0, 0, 0, 0, 0}, true, 1}),
    [](const auto& instance) { return instance.param.name; });

TEST(Components, are_numbered_in_the_order_of_their_first_vertices) {
    const auto parts = components(merged("two_components").K());
    ASSERT_EQ(parts.of_vertex.size(), 12U + 28U);
    for (std::size_t v = 0; v < parts.of_vertex.size(); ++v)
        EXPECT_EQ(parts.of_vertex[v], v < 12 ? 0 : 1);
}

TEST(Components, of_the_boundary_do_not_count_inner_vertices) {
    const auto& mesh = merged("ring6");
    const auto marks = boundary_cells(mesh.K());
    const auto parts = boundary_components(mesh.K());
    for (Index v = 0; v < mesh.K().size(0); ++v)
        EXPECT_EQ(parts.of_vertex[v] >= 0, marks[0][v]);
}

TEST(BettiNumbers, of_a_torus_of_one_square) {
    IncidenceMatrix d0(2, 1), d1(1, 2);
    EXPECT_EQ(betti_numbers(CellComplex({d0, d1})), (std::vector<Index>{1, 2, 1}));
}

class OrientableShapes : public testing::TestWithParam<std::string> {};

TEST_P(OrientableShapes, are_dual_to_their_relative_complexes) {
    // Lefschetz: b_k relative to the boundary is b_(n-k)
    const auto& P = merged(GetParam()).P();
    auto betti = betti_numbers(P);
    std::reverse(betti.begin(), betti.end());
    EXPECT_EQ(betti_numbers(relative_to_boundary(P).complex), betti);
}

INSTANTIATE_TEST_SUITE_P(Manifolds, OrientableShapes,
                         testing::Values("kuhn1d", "grid4", "ring6", "annulus9", "torus8x6",
                                         "kuhn3", "solid_torus3", "hollow_cube", "bcc2",
                                         "split_cubes", "kuhn4", "obtuse4", "kuhn5"),
                         parameter_name);

TEST(BettiNumbers, of_an_open_moebius_strip_see_that_it_is_one_sided) {
    EXPECT_EQ(betti_numbers(relative_to_boundary(merged("moebius12x2").P()).complex),
              (std::vector<Index>{0, 0, 0}));
}

/// A fan of triangles around a vertex, its first and last side glued: a disk with `sides` edges as
/// its boundary, which is a loop if there is one only.
GluedSurface cone(Index sides) {
    std::vector<std::array<GluedSurface::SignedEdge, 3>> triangles;
    for (Index i = 0; i < sides; ++i)
        triangles.push_back({{{i, 1}, {sides + i, 1}, {(i + 1) % sides, -1}}});
    return GluedSurface(triangles);
}

/// Two triangles on two vertices: a ring between two loops.
GluedSurface ring_of_two() {
    return GluedSurface({{{{0, 1}, {1, 1}, {2, -1}}}, {{{2, 1}, {3, -1}, {1, -1}}}});
}

TEST(Loops, on_the_boundary_have_their_vertex_there) {
    for (const Index sides : {1, 2, 3, 7}) {
        const auto complex = cell_complex(cone(sides));
        EXPECT_EQ(boundary_components(complex).count, 1) << sides;
        EXPECT_EQ(betti_numbers(complex), (std::vector<Index>{1, 0, 0})) << sides;
        EXPECT_EQ(betti_numbers(relative_to_boundary(complex).complex),
                  betti_numbers(relative_to_boundary(merged("grid4").P()).complex))
            << sides;
    }
    const auto ring = cell_complex(ring_of_two());
    EXPECT_EQ(boundary_components(ring).count, 2);
    EXPECT_EQ(betti_numbers(relative_to_boundary(ring).complex),
              betti_numbers(relative_to_boundary(merged("annulus9").P()).complex));
    const auto moebius = cell_complex(moebius_triangle());
    EXPECT_EQ(boundary_components(moebius).count, 1);
    EXPECT_EQ(betti_numbers(relative_to_boundary(moebius).complex),
              betti_numbers(relative_to_boundary(merged("moebius12x2").P()).complex));
}

TEST(Loops, are_incidences_that_cancel_and_are_kept_in_relative_complexes) {
    const auto complex = cell_complex(cone(1));
    ASSERT_EQ(complex.canceled(0).size(), 1U);
    EXPECT_EQ(complex.canceled(0)[0].cell, 1);
    EXPECT_EQ(complex.canceled(0)[0].face, complex.coboundary(0).coeff(0, 0) > 0 ? 0 : 1);
    ASSERT_EQ(complex.canceled(1).size(), 1U);
    EXPECT_EQ(complex.canceled(1)[0].face, 0);
    const auto all = relative_complex(complex, CellMarks{{false, false}, {false, false}, {false}});
    EXPECT_EQ(all.complex.canceled(0).size(), 1U);
    EXPECT_EQ(boundary_components(all.complex).count, 1);
}

/// One 2-cell that meets its only edge twice, in the same direction; the edge is a loop.
TEST(Loops, of_a_projective_plane_of_one_cell_are_no_boundary) {
    IncidenceMatrix d0(1, 1), d1(1, 1);
    d1.insert(0, 0) = 2;
    const CellComplex plane({d0, d1}, {{{0, 0}}, {}});
    EXPECT_EQ(plane.coface_counts(1)[0], 2);
    EXPECT_EQ(boundary_components(plane).count, 0);
}

TEST(LoopsBroken, without_what_cancels_the_boundary_of_a_cone_has_no_vertex) {
    const auto complex = cell_complex(cone(1));
    const CellComplex blind(CellComplex::Unchecked{},
                            {{complex.incidences(0), complex.coface_counts(0)},
                             {complex.incidences(1), complex.coface_counts(1)}});
    EXPECT_EQ(boundary_components(blind).count, 0);
    EXPECT_NE(betti_numbers(relative_to_boundary(blind).complex), (std::vector<Index>{0, 0, 1}));
}

TEST(Loops, can_be_told_by_hand) {
    IncidenceMatrix d0(1, 1), d1(1, 1);
    d1.insert(0, 0) = 1;
    const CellComplex disk({d0, d1}, {{{0, 0}}});
    EXPECT_EQ(disk.coface_counts(0)[0], 2);
    EXPECT_EQ(boundary_components(disk).count, 1);
    EXPECT_EQ(betti_numbers(relative_to_boundary(disk).complex), (std::vector<Index>{0, 0, 1}));
    EXPECT_REFUSED(CellComplex({d0, d1}, {{{0, 1}}}), "1-cell 0", "0-cell 1", "cancel", "d_0");
    EXPECT_REFUSED(CellComplex({d0, d1}, {{}, {{0, 0}}}), "2-cell 0", "1-cell 0", "cancel", "d_1");
    EXPECT_REFUSED(CellComplex({d0, d1}, {{}, {}, {}}), "incidences", "3 coboundaries", "2");
    EXPECT_REFUSED(relative_complex(disk, CellMarks{{false}, {true}, {false}}), "1-cell 0", "face",
                   "0-cell 0");
}

} // namespace polydec::test::in_topology
