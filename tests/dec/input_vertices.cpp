// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_input_vertices {

/// The mesh with a vertex that no cell uses in front of each third one, and behind the last.
Mesh with_unused_vertices(const Mesh& mesh) {
    std::vector<Index> number, old;
    for (Index v = 0; v < mesh.points.rows(); ++v) {
        if (v % 3 == 0)
            old.push_back(-1);
        number.push_back(static_cast<Index>(old.size()));
        old.push_back(v);
    }
    old.push_back(-1);
    Mesh result = mesh;
    result.points.resize(std::ssize(old), mesh.points.cols());
    for (Index v = 0; v < std::ssize(old); ++v)
        if (old[v] < 0)
            result.points.row(v).setConstant(0.5);
        else
            result.points.row(v) = mesh.points.row(old[v]);
    for (Index& corner : result.simplices.reshaped())
        corner = number[corner];
    return result;
}

class Vertices : public OverMeshes {};

TEST_P(Vertices, have_the_numbers_of_the_input) {
    const Mesh input = with_unused_vertices(mesh_named(GetParam()));
    const auto mesh = discretize(input);
    EXPECT_EQ(count_vertices(mesh), input.points.rows());
    const auto vertices = vertices_of_cells(mesh);
    ASSERT_EQ(std::ssize(vertices), mesh.complex().size(0));
    for (Index v = 0; v < std::ssize(vertices); ++v)
        EXPECT_EQ(mesh.points().row(v), input.points.row(vertices[v]));
    std::vector<Index> all(vertices.size());
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(cells_of_vertices(mesh, "sources", vertices), all);
    EXPECT_REFUSED(cells_of_vertices(mesh, "sources", {0}), "sources 0", "no cell", "vertex");
    EXPECT_REFUSED(cells_of_vertices(mesh, "sources", {-1}), "sources -1", "vertex", "numbered");
    EXPECT_REFUSED(cells_of_vertices(mesh, "sources", {count_vertices(mesh)}), "numbered", "0");
}

POLYDEC_OVER_MESHES(Vertices);

TEST(Vertices, that_splits_make_are_behind_those_of_the_input) {
    const Mesh input = with_unused_vertices(mesh_named("obtuse_planar"));
    const auto mesh = discretize(input, {.delaunay = Delaunay::flips_and_splits});
    ASSERT_GT(mesh.complex().size(0), mesh.input().size(0));
    const auto vertices = vertices_of_cells(mesh);
    EXPECT_EQ(vertices[mesh.input().size(0)], input.points.rows());
    EXPECT_EQ(vertices.back() + 1, count_vertices(mesh));
}

} // namespace polydec::test::in_input_vertices
