// SPDX-License-Identifier: MIT
#include "io/pictures/draw_cells.h"
#include "tests/support/merged.h"

#include <gtest/gtest.h>

namespace polydec::test {
namespace {

class MergedPolygons : public testing::TestWithParam<std::string> {};

TEST_P(MergedPolygons, are_the_merged_cells_and_nothing_else) {
    const auto& mesh = merged(GetParam());
    const auto polygons = polygon_mesh(mesh.merging(), mesh.points);
    EXPECT_NO_THROW(check_polygons(polygons));
    ASSERT_EQ(static_cast<Index>(polygons.offsets.size()), mesh.P().size(2) + 1);
    for (Index cell = 0; cell < mesh.P().size(2); ++cell) {
        const Index corners = polygons.offsets[cell + 1] - polygons.offsets[cell];
        EXPECT_GE(corners, 3);
        EXPECT_GE(corners, static_cast<Index>(mesh.merging().vertices(2, cell).size()));
    }
}

INSTANTIATE_TEST_SUITE_P(Surfaces, MergedPolygons,
                         testing::Values("grid4", "hex4", "wellcentred4", "ring6", "spike", "uv8",
                                         "torus8x6", "folded_rect", "branching", "goldberg2",
                                         "moebius12x2", "klein_bottle", "triangle_soup"),
                         [](const auto& instance) { return instance.param; });

} // namespace
} // namespace polydec::test
