// SPDX-License-Identifier: MIT
#include "tests/dec/discretized.h"
#include "tests/io/support.h"

namespace polydec::test::in_merged_polygons {

class MergedPolygons : public testing::TestWithParam<std::string> {};

TEST_P(MergedPolygons, are_the_merged_cells_and_nothing_else) {
    const auto& mesh = merged(GetParam());
    const auto polygons = polygon_mesh(mesh.merging(), mesh.points);
    EXPECT_NO_THROW(check_polygons(polygons));
    ASSERT_EQ(polygons.size(), mesh.P().size(2));
    for (Index cell = 0; cell < mesh.P().size(2); ++cell) {
        const auto corners = polygons.face(cell).size();
        EXPECT_GE(corners, 3);
        EXPECT_GE(corners, mesh.merging().vertices(2, cell).size());
    }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, MergedPolygons,
                         testing::Values("grid4", "hex4", "wellcentred4", "ring6", "spike", "uv8",
                                         "torus8x6", "folded_rect", "branching", "goldberg2",
                                         "moebius12x2", "klein_bottle", "triangle_soup"),
                         [](const auto& instance) { return instance.param; });

class PicturesOfCells : public OverMeshes {};

/// The corners and faces by the numbers of the input, as pictures of a mesh have them.
VtuGrid renumbered(VtuGrid grid, const SimplicialComplex& input) {
    grid.corners = input.vertex_numbers(std::move(grid.corners));
    for (std::size_t at = 0; at < grid.faces.size();)
        for (Index faces = grid.faces[at++]; faces > 0; --faces)
            for (Index corners = grid.faces[at++]; corners > 0; --corners, ++at)
                grid.faces[at] = input.vertex_number(grid.faces[at]);
    return grid;
}

TEST_P(PicturesOfCells, of_a_complex_and_points_alone_are_those_of_the_mesh) {
    const auto& whole = discretized(GetParam());
    const int n = whole.dimension(), N = static_cast<int>(whole.points().cols());
    for (int k = 0; k <= n; ++k) {
        const int drawn = k == 0 ? n : k;
        if (drawn > 3 || N > 3) {
            EXPECT_THROW(draw_cells(whole.complex(), whole.points(), k), InvalidInput);
            continue;
        }
        const VtuGrid own = draw_cells(whole.complex(), whole.points(), k);
        EXPECT_EQ(own.points, whole.points());
        EXPECT_EQ(std::ssize(own.types), whole.complex().size(drawn));
        // the edge inside the spike's cell cancels, and so does not show in the complex
        EXPECT_EQ(same(renumbered(own, whole.input()), draw_cells(whole, k)),
                  GetParam() != "spike" || drawn != 2)
            << "degree " << k;
    }
}

POLYDEC_OVER_MESHES(PicturesOfCells);

TEST(PicturesOfOtherCells, differ_or_are_refused) {
    const auto squares = discretize(grid(2, 2));
    EXPECT_NE(draw_cells(squares.complex(), squares.points(), 2).corners,
              draw_cells(squares.input(), squares.points(), 2).corners);
    EXPECT_THROW(draw_cells(squares.complex(), squares.points().topRows(8), 2), InvalidInput);
}

} // namespace polydec::test::in_merged_polygons
