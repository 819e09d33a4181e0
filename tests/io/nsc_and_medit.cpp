// SPDX-License-Identifier: MIT
#include "tests/io/support.h"

namespace polydec::test::in_nsc_and_medit {

using Cells = std::vector<std::vector<Index>>;

const std::string medit = "MeshVersionFormatted 2\nDimension 3\nVertices\n5\n0 0 0 0\n1 0 0 1\n"
                          "0 1 0 2\n0 0 1 0\n1 1 1 0\n";

TEST(Nsc, ReadsEveryDimension) {
    const auto line = read_from("a.nsc", "1 1 2 1\n0\n1\n0 1\n");
    EXPECT_EQ(line.ambient_dimension(), 1);
    EXPECT_EQ(rows(line.simplices), (Cells{{0, 1}}));

    const auto simplex = read_from("a.nsc", "# four\n4 4 5 1 # sizes\n0 0 0 0\n1 0 0 0\n\n0 1 0 0\n"
                                            "0 0 1 0\n0 0 0 1 # last\n4 3 2 1 0");
    EXPECT_EQ(simplex.ambient_dimension(), 4);
    EXPECT_EQ(rows(simplex.simplices), (Cells{{4, 3, 2, 1, 0}}));
}

TEST(Nsc, RefusesWhatDoesNotFit) {
    EXPECT_UNREADABLE("a.nsc", "2 3 3 1\n0 0\n1 0\n0 1\n0 1 2\n", "a.nsc:1", "dimension 3",
                      "ambient dimension 2");
    EXPECT_UNREADABLE("a.nsc", "2 0 3 1\n0 0\n1 0\n0 1\n0 1 2\n", "a.nsc:1", "dimension 0",
                      "ambient dimension 2");
    EXPECT_UNREADABLE("a.nsc", "2 2 3 1 7\n0 0\n1 0\n0 1\n0 1 2\n", "a.nsc:1", "7", "line", "N n");
    EXPECT_UNREADABLE("a.nsc", "2 2 3 1\n0\n1 0\n0 1\n0 1 2\n", "a.nsc:2", "line ends", "vertex",
                      "2 coordinates");
    EXPECT_UNREADABLE("a.nsc", "2 2 3 1\n0 0 0\n1 0\n0 1\n0 1 2\n", "a.nsc:2", "0", "line",
                      "vertex", "2 coordinates");
    EXPECT_UNREADABLE("a.nsc", "2 2 3 1\n0 0\n1 0\n0 1\n0 1\n", "a.nsc:5", "line ends", "simplex",
                      "3");
    EXPECT_UNREADABLE("a.nsc", "2 2 3 1\n0 0\n1 0\n0 1\n0 1 3\n", "a.nsc:5", "vertex", "3", "range",
                      "0", "2");
    EXPECT_UNREADABLE("a.nsc", "2 2 3 1\n0 0\n1 0\n0 1\n0 1 2\n2 1 0\n", "a.nsc:6", "1 simplices",
                      "end");
    EXPECT_UNREADABLE("a.nsc", "2 2 3 1\n0 0\n1 inf\n0 1\n0 1 2\n", "a.nsc:3", "vertex 1",
                      "coordinate", "NaN");
    EXPECT_UNREADABLE("a.nsc", "2000000000 2 3 1\n0 0\n", "a.nsc:1", "2000000000 coordinates",
                      "vertex", "11 bytes", "2 bytes");
}

TEST(Medit, TakesTheCellsOfHighestDimension) {
    const std::string edges = "Edges\n1\n1 2 0\n";
    const std::string triangles = "Triangles\n2\n1 2 3 0\n1 3 4 7\n";
    const std::string tetrahedra = "Tetrahedra 1\n1 2 3 4 0\n";
    EXPECT_EQ(rows(read_from("a.mesh", medit + edges).simplices), (Cells{{0, 1}}));
    EXPECT_EQ(rows(read_from("a.mesh", medit + edges + triangles).simplices),
              (Cells{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_EQ(rows(read_from("a.mesh", medit + tetrahedra + triangles + "End\njunk").simplices),
              (Cells{{0, 1, 2, 3}}));
    EXPECT_EQ(rows(read_from("a.mesh", medit + triangles + "Tetrahedra 0\nEnd\n").simplices),
              (Cells{{0, 1, 2}, {0, 2, 3}}));
}

TEST(Medit, ReferencesAreTagsUnlessAllAreZero) {
    EXPECT_EQ(read_from("a.mesh", medit + "Triangles\n2\n1 2 3 0\n1 3 4 7\n").tags,
              (std::vector<Index>{0, 7}));
    EXPECT_TRUE(read_from("a.mesh", medit + "Triangles\n1\n1 2 3 0\n").tags.empty());
    const auto mesh = read_from("a.mesh", medit + "Triangles\n1\n1 2 3 0.5\n");
    EXPECT_TRUE(mesh.tags.empty());
    EXPECT_EACH_SAYS(mesh.warnings, {"groups", "1 cell", "0.5"});
}

TEST(Medit, TagsAreWrittenAndReadBack) {
    const TemporaryFolder folder;
    Mesh mesh = read_from("a.mesh", medit + "Triangles\n2\n1 2 3 4\n1 3 4 7\n");
    write_mesh(folder.path("b.mesh"), mesh);
    EXPECT_EQ(read_mesh(folder.path("b.mesh")).tags, (std::vector<Index>{4, 7}));
    mesh.tags = {4};
    EXPECT_REFUSED(write_mesh("c.mesh", mesh), "c.mesh", "1 tags", "2 simplices");
}

TEST(Medit, ReferencesOfFacetsAreTheirTagsAndZeroIsNone) {
    const std::string edges = "Edges\n2\n1 2 0\n3 2 -4\n";
    const std::string triangles = "Triangles\n2\n1 2 3 0\n1 3 4 7\n";
    const std::string tetrahedra = "Tetrahedra\n1\n1 2 3 4 0\n";
    const auto surface = read_from("a.mesh", medit + edges + triangles);
    EXPECT_EQ(rows(surface.facet_tags.simplices), (Cells{{2, 1}}));
    EXPECT_EQ(surface.facet_tags.tags, (std::vector<Index>{-4}));
    const auto solid = read_from("a.mesh", medit + edges + triangles + tetrahedra);
    EXPECT_EQ(rows(solid.facet_tags.simplices), (Cells{{0, 2, 3}}));
    EXPECT_EQ(solid.facet_tags.tags, (std::vector<Index>{7}));
    EXPECT_TRUE(read_from("a.mesh", medit + edges).facet_tags.tags.empty());
    EXPECT_TRUE(read_from("a.mesh", medit + "Edges\n2\n1 2 0.5\n3 2 4\n" + triangles)
                    .facet_tags.tags.empty());
}

TEST(Medit, GroupsOfVerticesOfCurvesAreRefused) {
    const TemporaryFolder folder;
    Mesh curve = read_from("a.mesh", medit + "Edges\n2\n1 2 4\n3 2 7\n");
    write_mesh(folder.path("b.mesh"), curve);
    curve.facet_tags.simplices = Simplices::Zero(1, 1);
    curve.facet_tags.tags = {5};
    EXPECT_REFUSED(write_mesh(folder.path("b.mesh"), curve), "b.mesh", "groups", "curve",
                   "facet_tags");
}

TEST(Medit, CellsOfEveryDimensionThatNameNoVertexAreRefused) {
    const std::string tetrahedra = "Tetrahedra\n1\n1 2 3 4 0\n";
    EXPECT_UNREADABLE("a.mesh", medit + tetrahedra + "Triangles\n1\n1 2 9 3\n", "a.mesh:15",
                      "vertex", "9", "range", "1", "5");
    EXPECT_UNREADABLE("a.mesh", medit + tetrahedra + "Edges\n1\n1 9 3\n", "a.mesh:15", "vertex",
                      "9", "range", "1", "5");
}

TEST(Medit, SectionsMayComeInAnyOrderAndUnknownOnesAreLeftOut) {
    const auto mesh =
        read_from("a.mesh", "MeshVersionFormatted\n1\n# comment\nTriangles\n1\n1 2 3 0\n"
                            "Corners\n2\n1\n2\nDimension\n2\nVertices\n3\n0 0 1\n1 0 1\n"
                            "0 1 1\nNormals\n1\n0 0 1\n");
    EXPECT_EQ(mesh.ambient_dimension(), 2);
    EXPECT_EQ(rows(mesh.simplices), (Cells{{0, 1, 2}}));
}

TEST(Medit, RefusesWhatDoesNotFit) {
    EXPECT_UNREADABLE("a.mesh", medit + "Hexahedra\n1\n1 2 3 4 5 1 2 9 0\n", "a.mesh:12", "vertex",
                      "9", "range", "1", "5");
    EXPECT_UNREADABLE("a.mesh", medit + "Triangles\n1\n0 2 3 0\n", "a.mesh:12", "vertex", "0",
                      "range", "1", "5");
    EXPECT_UNREADABLE("a.mesh", medit + "Triangles\n1\n1 2 3 0\nTriangles\n1\n1 2 3 0\n",
                      "a.mesh:13", "Triangles", "twice");
    EXPECT_UNREADABLE("a.mesh", "Dimension 4\nVertices\n1\n0 0 0 0 0\n", "a.mesh:1", "Dimension 4",
                      "2", "3");
    EXPECT_UNREADABLE("a.mesh", "Dimension 3\n", "a.mesh:1", "section", "Vertices");
    EXPECT_UNREADABLE("a.mesh", medit + "Triangles\n2\n1 2 3 0\nCorners 0\n", "a.mesh:13",
                      "Corners", "whole number", "vertex");
    EXPECT_UNREADABLE("a.mesh", medit + "Tetrahedra\n500\n1 2 3 4 0\n", "a.mesh:11",
                      "500 Tetrahedra", "11 bytes", "10 bytes");
    EXPECT_UNREADABLE("a.mesh", medit + "Triangles\n1\n1 2 3 0\n1 3 4 0\nEnd\n", "a.mesh:13",
                      "1 Triangles", "keyword", "end");
    EXPECT_UNREADABLE("a.mesh", medit + "2 2 2 0\nTriangles\n1\n1 2 3 0\n", "a.mesh:10",
                      "5 Vertices", "keyword", "end");
    EXPECT_UNREADABLE("a.mesh", "Dimension 3\nVertices 2\nnan 0 0 0\n1 nan 0 0\n", "a.mesh:3",
                      "vertex 0", "coordinate", "NaN");
    EXPECT_UNREADABLE("a.mesh", medit, "a.mesh: ", "5 vertices", "no cells");
}

} // namespace polydec::test::in_nsc_and_medit
