// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_chosen_vertices {

/// A square of four triangles with facets of two groups, of which one lies inside.
Mesh grouped_square() {
    Mesh mesh{Points(5, 2), Simplices(4, 3), {}};
    mesh.points << 0, 0, 2, 0, 2, 2, 0, 2, 1, 1;
    mesh.simplices << 0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4;
    mesh.tags = {1, 1, 2, 2};
    mesh.facet_tags.simplices.resize(3, 2);
    mesh.facet_tags.simplices << 0, 1, 1, 2, 2, 4;
    mesh.facet_tags.tags = {7, 7, 9};
    mesh.groups = {{1, 7, "wall"}, {1, 9, "inner"}, {2, 2, "upper"}};
    return mesh;
}

TEST(ChosenVertices, are_those_of_a_group_and_the_boundary) {
    const auto mesh = discretize(grouped_square(),
                                 {.criterion = MergeCriterion::none, .star = StarKind::galerkin});
    using List = std::vector<Index>;
    EXPECT_EQ(boundary_vertices(mesh), (List{0, 1, 2, 3}));
    EXPECT_EQ(vertices_on(mesh, {"wall"}), (List{0, 1, 2}));
    EXPECT_EQ(vertices_on(mesh, {"9"}), (List{2, 4}));
    EXPECT_EQ(vertices_on(mesh, {"inner", "wall"}), (List{0, 1, 2, 4}));
    EXPECT_EQ(vertices_on(mesh, {"upper"}), (List{0, 2, 3, 4}));
    EXPECT_REFUSED(vertices_on(mesh, {"floor"}), "floor", "wall", "inner");
    EXPECT_REFUSED(vertices_on(mesh, {"77"}), "no facet", "77", "wall");
    EXPECT_REFUSED(boundary_vertices(discretize(icosphere(1))), "boundary");
}

} // namespace polydec::test::in_chosen_vertices
