// SPDX-License-Identifier: MIT
#include "complex/surfaces/ordered_surface.h"
#include "tests/support/test.h"

namespace polydec::test::in_pieces {

std::vector<Index> ascending(Index size) {
    std::vector<Index> numbers(static_cast<std::size_t>(size));
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

/// The face tables of a complex, as one would write them by hand.
std::vector<Simplices> face_tables(const Pieces& pieces) {
    std::vector<Simplices> tables;
    for (int k = 1; k <= pieces.dimension(); ++k) {
        Simplices table(pieces.size(k), k + 1);
        for (Index s = 0; s < pieces.size(k); ++s)
            for (int i = 0; i <= k; ++i)
                table(s, i) = pieces.face(k, s, i);
        tables.push_back(std::move(table));
    }
    return tables;
}

std::vector<std::int8_t> orientations(const Pieces& pieces) {
    std::vector<std::int8_t> signs;
    for (Index t = 0; t < pieces.size(pieces.dimension()); ++t)
        signs.push_back(static_cast<std::int8_t>(pieces.orientation(t)));
    return signs;
}

class PiecesOf : public OverMeshes {};

TEST_P(PiecesOf, a_simplicial_complex_are_glued_again_from_its_faces) {
    const auto& K = mesh().K();
    std::vector<Index> numbers;
    for (Index v = 0; v < K.size(0); ++v)
        numbers.push_back(K.vertex_number(v));
    const Pieces again(face_tables(K), orientations(K), numbers);
    EXPECT_EQ(again.orientable(), K.orientable());
    for (int k = 0; k <= K.dimension(); ++k) {
        EXPECT_EQ(again.simplices(k), K.simplices(k)) << "degree " << k;
        EXPECT_EQ(again.coface_counts(k), K.coface_counts(k)) << "degree " << k;
        EXPECT_TRUE(equal(integers(again.coboundary(k)), integers(K.coboundary(k)))) << k;
    }
}

TEST_P(PiecesOf, a_simplicial_complex_have_the_signs_and_cofaces_of_its_coboundary) {
    const auto& K = mesh().K();
    for (int k = 1; k <= K.dimension(); ++k) {
        const Cofaces cofaces(K, k);
        Index incidences = 0;
        for (Index f = 0; f < K.size(k - 1); ++f)
            for (const auto& [cell, omitted] : cofaces.of(f)) {
                ++incidences;
                EXPECT_EQ(K.face(k, cell, omitted), f);
                EXPECT_EQ(K.sign(k, cell, omitted), K.coboundary(k - 1).coeff(cell, f));
            }
        EXPECT_EQ(incidences, K.coboundary(k - 1).nonZeros());
    }
}

POLYDEC_OVER_MESHES(PiecesOf);

/// In order, a surface is the same but for the directions of its edges.
void expect_same(const GluedSurface& surface) {
    const auto [pieces, directions] = in_order(surface, ascending(surface.vertices()));
    const CellComplex cells = cell_complex(surface);
    IntegerMatrix turn(surface.edges(), surface.edges());
    for (Index e = 0; e < surface.edges(); ++e)
        turn.insert(e, e) = static_cast<int>(directions[e]);
    EXPECT_TRUE(equal(integers(pieces.coboundary(0)), turn * integers(cells.coboundary(0))));
    EXPECT_TRUE(equal(integers(pieces.coboundary(1)), integers(cells.coboundary(1)) * turn));
    EXPECT_EQ(betti_numbers(pieces), betti_numbers(cells));
    for (int k = 0; k <= 2; ++k)
        EXPECT_EQ(pieces.coface_counts(k), cells.coface_counts(k));
    for (Index e = 0; e < surface.edges(); ++e)
        EXPECT_LE(pieces.simplices(1)(e, 0), pieces.simplices(1)(e, 1));
}

TEST(OrderedSurfaces, of_few_triangles_are_in_order) {
    for (const auto& surface :
         {square_torus(), square_klein(), two_sided_plane(), folded_triangle(), moebius_triangle()})
        expect_same(surface);
}

TEST(OrderedSurfaces, stay_in_order_whatever_is_flipped) {
    for (const auto& name : names_of_surfaces()) {
        GluedSurface surface(merged(name).K());
        flip_at_random(surface, 3);
        expect_same(surface);
    }
}

TEST(OrderedSurfaces, of_one_vertex_and_any_genus_have_no_triangle_that_is_a_circle) {
    // polygons of 4 g sides a b a^-1 b^-1 .., fanned from a corner: all vertices become one
    for (const Index genus : {1, 2, 3, 7}) {
        const Index sides = 4 * genus, diagonals = sides - 3, first_diagonal = 2 * genus;
        const auto side = [&](Index i) -> GluedSurface::SignedEdge {
            const Index handle = i / 4, place = i % 4;
            return {2 * handle + place % 2, static_cast<std::int8_t>(place < 2 ? 1 : -1)};
        };
        std::vector<std::array<GluedSurface::SignedEdge, 3>> triangles;
        for (Index t = 0; t <= diagonals; ++t)
            triangles.push_back(
                {t == 0 ? side(0) : GluedSurface::SignedEdge{first_diagonal + t - 1, 1},
                 side(t + 1),
                 t == diagonals ? side(sides - 1)
                                : GluedSurface::SignedEdge{first_diagonal + t, -1}});
        const GluedSurface surface(triangles);
        ASSERT_EQ(surface.vertices(), 1);
        expect_same(surface);
        EXPECT_EQ(betti_numbers(in_order(surface, {0}).pieces),
                  (std::vector<Index>{1, 2 * genus, 1}));
    }
}

TEST(PiecesAre, refused_by_name_where_their_tables_do_not_fit) {
    const Simplices ends{{1, 0}, {2, 1}, {2, 0}};
    const auto glue = [](Simplices edges, Simplices triangles, std::vector<std::int8_t> signs) {
        return refusal([&] { Pieces({edges, triangles}, signs, {0, 1, 2}); });
    };
    EXPECT_EQ(glue(ends, Simplices{{1, 2, 0}}, {1}), "accepted");
    EXPECT_SAYS(glue(ends, Simplices{{1, 0, 2}}, {1}), "faces", "2-simplex 0", "corners 0", "1");
    EXPECT_SAYS(glue(ends, Simplices{{1, 2, 3}}, {1}), "face 2", "2-simplex 0", "3", "0", "2");
    EXPECT_SAYS(glue(ends, Simplices{{1, 2}}, {1}), "2 faces", "2-simplex", "3");
    EXPECT_SAYS(glue(ends, Simplices{{1, 2, 0}}, {2}), "orientation", "simplex 0", "2", "1", "-1");
    EXPECT_REFUSED(Pieces({ends, Simplices{{1, 2, 0}}}, {1}, {0, 1, -2}), "vertex 2", "-2", "0");
    EXPECT_SAYS(glue(ends, Simplices{{1, 2, 0}}, {}), "0 orientations", "1");
}

} // namespace polydec::test::in_pieces
