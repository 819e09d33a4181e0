// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_input_cells {

using Numbers = std::vector<Index>;

/// A square, a face of two corners, a triangle and a square, in a row.
Mesh row() {
    PolygonMesh faces;
    faces.points.resize(8, 2);
    faces.points << 0, 0, 1, 0, 3, 0, 4, 0, 0, 1, 1, 1, 3, 1, 4, 1;
    faces.corners = {0, 1, 5, 4, 1, 2, 1, 2, 5, 2, 3, 7, 6};
    faces.offsets = {0, 4, 6, 9, 13};
    faces.tags = {7, 8, 9, 10};
    return split_polygons(std::move(faces));
}

TEST(InputCells, are_those_that_were_split) {
    const Mesh mesh = row();
    EXPECT_EQ(mesh.input_cells.of_simplices, (Numbers{0, 0, 2, 3, 3}));
    EXPECT_EQ(mesh.input_cells.count, 4);
    EXPECT_EQ(mesh.tags, (Numbers{7, 7, 9, 10, 10}));
    EXPECT_TRUE(grid(2, 2).input_cells.of_simplices.empty());
}

TEST(InputCells, are_known_when_others_are_left_out) {
    Mesh mesh = row();
    mesh.simplices.row(1) << 0, 0, 1; // the square has one triangle less
    const Mesh tidied = tidy(mesh);
    EXPECT_EQ(tidied.input_cells.of_simplices, (Numbers{0, 2, 3, 3}));
    EXPECT_EQ(tidied.input_cells.count, 4);
    Mesh simplices = grid(2, 1);
    simplices.simplices.row(0) << 0, 0, 1;
    EXPECT_EQ(tidy(simplices).input_cells.of_simplices, (Numbers{1, 2, 3}));
    EXPECT_EQ(tidy(simplices).input_cells.count, 4);
    EXPECT_TRUE(tidy(grid(2, 1)).input_cells.of_simplices.empty());
}

TEST(InputCells, are_known_when_cells_are_divided_or_peeled) {
    const Mesh hanging =
        made_of({{0, 0}, {2, 0}, {1, 0}, {1, 1}, {1, -2}}, {{0, 2, 3}, {0, 4, 1}, {2, 1, 3}});
    EXPECT_EQ(join_hanging(hanging).mesh.input_cells.of_simplices, (Numbers{0, 1, 1, 2}));
    const Mesh sliver = made_of({{0, 0}, {1, 0}, {0.5, 1}, {0.5, -1e-14}}, {{0, 3, 1}, {0, 1, 2}});
    EXPECT_EQ(peeled(sliver).input_cells.of_simplices, (Numbers{1}));
}

TEST(InputCells, go_with_simplices_that_are_shuffled) {
    const Mesh mesh = row();
    const auto [other, vertices, cells] = shuffled(mesh, 5);
    for (std::size_t t = 0; t < cells.size(); ++t)
        EXPECT_EQ(other.input_cells.of_simplices[t], mesh.input_cells.of_simplices[cells[t]]);
    EXPECT_EQ(other.input_cells.count, 4);
    EXPECT_TRUE(shuffled(grid(2, 1), 1).mesh.input_cells.of_simplices.empty());
}

} // namespace polydec::test::in_input_cells
