// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_cell_complex {

IncidenceMatrix incidences(const std::vector<std::vector<int>>& rows, Index columns) {
    IncidenceMatrix D(static_cast<Index>(rows.size()), columns);
    for (Index i = 0; i < D.rows(); ++i)
        for (Index j = 0; j < columns; ++j)
            if (rows[i][j] != 0)
                D.insert(i, j) = static_cast<std::int8_t>(rows[i][j]);
    return D;
}

const IncidenceMatrix triangle_edges = incidences({{-1, 1, 0}, {-1, 0, 1}, {0, -1, 1}}, 3);

TEST(CellComplex, is_made_of_matrices_that_fit) {
    const CellComplex triangle({triangle_edges, incidences({{1, -1, 1}}, 3)});
    EXPECT_EQ(triangle.dimension(), 2);
    EXPECT_EQ(triangle.size(0), 3);
    EXPECT_EQ(triangle.size(1), 3);
    EXPECT_EQ(triangle.size(2), 1);
    EXPECT_EQ(triangle.coface_counts(0), (std::vector<Index>{2, 2, 2}));
    EXPECT_EQ(triangle.coface_counts(2), (std::vector<Index>{0}));
    EXPECT_EQ(euler_characteristic(triangle), 1);
}

TEST(CellComplex, refuses_faces_that_do_not_close_up_and_names_their_degree) {
    EXPECT_REFUSED(CellComplex({triangle_edges, incidences({{1, 1, 1}}, 3)}), "d_1 d_0", "-2",
                   "0-cell 0", "2-cell 0");
    const auto d1 = incidences({{0, 0, 0}, {0, 0, 0}}, 3), d2 = incidences({{1, -1}}, 2);
    EXPECT_NO_THROW(CellComplex({triangle_edges, d1, d2}));
    const auto broken = incidences({{1, -1, 1}, {1, -1, 1}}, 3);
    EXPECT_NO_THROW(CellComplex({triangle_edges, broken, d2}));
    EXPECT_REFUSED(CellComplex({triangle_edges, broken, incidences({{1, 1}}, 2)}), "d_2 d_1", "2",
                   "1-cell 0", "3-cell 0");
}

TEST(CellComplex, refuses_matrices_that_do_not_fit) {
    EXPECT_REFUSED(CellComplex({triangle_edges, incidences({{1, -1}}, 2)}), "d_0", "3 rows", "d_1",
                   "2 columns");
    EXPECT_REFUSED(CellComplex(std::vector<IncidenceMatrix>{}), "d_0", "dimension 1");
}

TEST(CellComplex, refuses_to_give_a_coboundary_beyond_its_degrees) {
    const CellComplex curve({triangle_edges});
    EXPECT_REFUSED(curve.coboundary(2), "coboundary 2", "dimension 1", "-1", "1");
    EXPECT_REFUSED(curve.coboundary(-2), "coboundary -2", "dimension 1", "-1", "1");
}

TEST(CellComplex, does_not_take_stored_zeros_for_cofaces) {
    IncidenceMatrix d0 = triangle_edges;
    d0.valuePtr()[0] = 0;
    const CellComplex curve({d0});
    EXPECT_EQ(curve.coface_counts(0), (std::vector<Index>{1, 2, 2}));
    EXPECT_EQ(curve.coboundary(0).nonZeros(), 5);
}

std::string refused_simplices(const std::vector<std::vector<Index>>& tops) {
    return refusal([&] { SimplicialComplex(made_of({{0}}, tops).simplices); });
}

TEST(SimplicialComplex, refuses_by_name_what_is_no_list_of_different_simplices) {
    EXPECT_SAYS(refused_simplices({{0, 1, 2}, {3, 1, 3}}), "cell 1", "corner", "1, 3, 3");
    EXPECT_SAYS(refused_simplices({{5, 1, 2}, {0, 1, 2}, {2, 5, 1}}), "cells 0", "2",
                "vertices 1, 2, 5");
    EXPECT_SAYS(refused_simplices({{0, 1, 2}, {1, -2, 2}}), "vertex number -2");
    const Words is_empty{"one simplex", "dimension 1"};
    EXPECT_REFUSED(SimplicialComplex(Simplices(0, 3)), is_empty);
    EXPECT_REFUSED(SimplicialComplex(Simplices(0, 0)), is_empty);
    EXPECT_TRUE(says(refused_simplices({{0}, {1}}), is_empty));
}

TEST(SimplicialComplex, counts_used_vertices_alone) {
    const SimplicialComplex K(made_of({{0}}, {{7, 100, 2}}).simplices);
    EXPECT_EQ(K.size(0), 3);
    EXPECT_EQ(K.vertex_numbers(2, 0), (std::vector<Index>{2, 7, 100}));
}

} // namespace polydec::test::in_cell_complex
