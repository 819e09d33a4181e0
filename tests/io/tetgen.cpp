// SPDX-License-Identifier: MIT
#include "io/meshes/readers.h"
#include "tests/io/support.h"

namespace polydec::test::in_tetgen {

using Cells = std::vector<std::vector<Index>>;

const std::string nodes = "# made by hand\n5 3 2 1\n1 0 0 0 0.5 0.5 1\n2 1 0 0 0 0 0\n"
                          "3 0 1 0 0 0 0 # a corner\n\n4 0 0 1 0 0 0\n5 1 1 1.25 0 0 0\n";
const std::string nodes_from_zero = "5 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n4 1 1 1.25\n";
const std::string planar = "4 2 0 1\n1 0 0 1\n2 1 0 1\n3 1 1 1\n4 0 1 1\n";

Mesh parsed(const std::string& node, const std::string& ele) {
    return parse_tetgen({"a.node", node}, {SourceFile{"a.ele", ele}});
}

TEST(TetGen, NumberingFromOneAndFromZeroIsTheSame) {
    const auto mesh = parsed(nodes, "2 4 0\n1 1 2 3 4\n2 2 3 4 5\n# end\n");
    EXPECT_EQ(rows(mesh.points), (std::vector<std::vector<double>>{
                                     {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1.25}}));
    EXPECT_EQ(rows(mesh.simplices), (Cells{{0, 1, 2, 3}, {1, 2, 3, 4}}));
    EXPECT_TRUE(mesh.tags.empty());
    EXPECT_TRUE(same(mesh, parsed(nodes_from_zero, "2 4 0\n0 0 1 2 3\n1 1 2 3 4\n")));
    EXPECT_TRUE(same(mesh, parsed(nodes_from_zero, "2 4 0\n1 0 1 2 3\n2 1 2 3 4\n")));
    EXPECT_FALSE(same(mesh, parsed(nodes_from_zero, "2 4 0\n0 1 2 3 4\n1 1 2 3 4\n")));
}

TEST(TetGen, TheLastAttributeIsTheTagIfWhole) {
    EXPECT_EQ(parsed(nodes, "2 4 1\n1 1 2 3 4 7\n2 2 3 4 5 -1\n").tags,
              (std::vector<Index>{7, -1}));
    EXPECT_EQ(parsed(nodes, "2 4 2\n1 1 2 3 4 0.5 7\n2 2 3 4 5 0.5 8\n").tags,
              (std::vector<Index>{7, 8}));
    EXPECT_TRUE(parsed(nodes, "2 4 1\n1 1 2 3 4 7.5\n2 2 3 4 5 1\n").tags.empty());
    EXPECT_TRUE(parsed(nodes, "2 4 1\n1 1 2 3 4 0\n2 2 3 4 5 0\n").tags.empty());
}

TEST(TetGen, TrianglesInThePlaneAreRead) {
    const auto mesh = parsed(planar, "2 3 0\n1 1 2 3\n2 1 3 4\n");
    EXPECT_EQ(mesh.ambient_dimension(), 2);
    EXPECT_EQ(rows(mesh.simplices), (Cells{{0, 1, 2}, {0, 2, 3}}));
}

TEST(TetGen, EitherOfTheTwoFilesNamesTheMesh) {
    const TemporaryFolder folder;
    folder.write("a.1.node", nodes);
    const auto face = folder.write("a.1.face", "1 1\n1 1 2 3 9\n");
    EXPECT_EQ(rows(read_mesh(folder.path("a.1.node")).simplices), (Cells{{0, 1, 2}}));
    EXPECT_EQ(read_mesh(folder.path("a.1.node")).tags, (std::vector<Index>{9}));
    folder.write("a.1.ele", "1 4 0\n1 1 2 3 4\n");
    EXPECT_EQ(rows(read_mesh(folder.path("a.1.node")).simplices), (Cells{{0, 1, 2, 3}}));
    EXPECT_EQ(rows(read_mesh(folder.path("a.1.ele")).simplices), (Cells{{0, 1, 2, 3}}));
    for (const char* name : {"a.1.node", "a.1.ele"})
        EXPECT_EQ(read_mesh(folder.path(name)).facet_tags.tags, (std::vector<Index>{9})) << name;
}

TEST(TetGen, NeighborsOfFacesAreLeftOut) {
    for (const char* face : {"1 1\n1 1 2 3 0 17 -1\n", "1 0\n1 1 2 3 17 -1\n"}) {
        const auto mesh = parse_tetgen({"a.node", nodes}, {SourceFile{"a.face", face}});
        EXPECT_EQ(rows(mesh.simplices), (Cells{{0, 1, 2}}));
        EXPECT_TRUE(mesh.tags.empty());
    }
}

/// With nodes on their sides and neighbors, or without.
TEST(TetGen, MarkersOfFacetsBesideTheCellsAreGroups) {
    const SourceFile node{"a.node", nodes}, ele{"a.ele", "1 4 1\n1 1 2 3 4 8\n"};
    const SourceFile ten{"a.ele", "1 10 1\n1 1 2 3 4 5 5 5 5 5 5 8\n"};
    const SourceFile edge{"a.edge", "1 1\n1 1 2 6 1\n"};
    for (const char* face : {"3 1\n# all\n1 1 2 3 9\n2 1 2 4 0\n3 2 3 4 -1\n",
                             "3 1\n0 1 2 3 9 1 -1\n1 1 2 4 0 1 -1\n2 2 3 4 -1 1 -1\n",
                             "3 1\n1 1 2 3 5 5 5 9\n2 1 2 4 5 5 5 0\n3 2 3 4 5 5 5 -1\n"})
        for (const SourceFile& cells : {ele, ten}) {
            const auto mesh = parse_tetgen(node, {cells, SourceFile{"a.face", face}, edge});
            EXPECT_EQ(rows(mesh.simplices), (Cells{{0, 1, 2, 3}})) << face;
            EXPECT_EQ(mesh.tags, std::vector<Index>{8}) << face;
            EXPECT_EQ(rows(mesh.facet_tags.simplices), (Cells{{0, 1, 2}, {1, 2, 3}})) << face;
            EXPECT_EQ(mesh.facet_tags.tags, (std::vector<Index>{9, -1})) << face;
        }
    const auto in_plane = parse_tetgen({"a.node", planar},
                                       {SourceFile{"a.ele", "2 3 0\n1 1 2 3\n2 1 3 4\n"},
                                        SourceFile{"a.edge", "3 1\n1 1 2 5\n2 2 3 6\n3 1 3 0\n"}});
    EXPECT_EQ(rows(in_plane.facet_tags.simplices), (Cells{{0, 1}, {1, 2}}));
    EXPECT_EQ(in_plane.facet_tags.tags, (std::vector<Index>{5, 6}));
}

/// Of the option -o2, where .face and .edge alone make the mesh, and with neighbors or without.
TEST(TetGen, NodesOnEdgesAreNoMarkers) {
    const SourceFile node{"a.node",
                          "10 3 0 0\n0 0 0 0\n1 2 0 0\n2 0 2 0\n3 0 0 2\n4 1 0 0\n5 0 1 0\n"
                          "6 0 0 1\n7 1 1 0\n8 1 0 1\n9 0 1 1\n"};
    const SourceFile face{"a.face", "2 1\n0 0 1 2 7 5 4 3\n1 0 1 3 8 6 4 3\n"};
    for (const char* edge :
         {"3 1\n0 0 1 5\n1 0 2 -1\n2 1 2 0\n", "3 1\n0 0 1 5 8\n1 0 2 -1 8\n2 1 2 0 8\n",
          "3 1\n0 0 1 4 5\n1 0 2 5 -1\n2 1 2 7 0\n",
          "3 1\n0 0 1 4 5 8\n1 0 2 5 -1 8\n2 1 2 7 0 8\n"}) {
        const auto mesh = parse_tetgen(node, {face, SourceFile{"a.edge", edge}});
        EXPECT_EQ(rows(mesh.simplices), (Cells{{0, 1, 2}, {0, 1, 3}})) << edge;
        EXPECT_EQ(rows(mesh.facet_tags.simplices), (Cells{{0, 1}, {0, 2}})) << edge;
        EXPECT_EQ(mesh.facet_tags.tags, (std::vector<Index>{5, -1})) << edge;
    }
}

TEST(TetGen, SaysWhichFileIsMissing) {
    const TemporaryFolder folder;
    const auto node = folder.write("a.node", nodes);
    EXPECT_REFUSED(read_mesh(node), node.string(), folder.path("a.ele").string(), ".face");
    const auto ele = folder.write("b.ele", "1 4 0\n1 1 2 3 4\n");
    EXPECT_ERROR(IoError, read_mesh(ele), folder.path("b.node").string(), "No such file");
}

TEST(TetGen, RefusesWhatDoesNotFit) {
    const std::string ele = "1 4 0\n1 1 2 3 4\n";
    EXPECT_REFUSED(parsed(nodes, "1 9 0\n1 1 2 3 4 1 2 3 4 1\n"), "a.ele:1", "9 corners", "4");
    EXPECT_REFUSED(parsed(planar, "1 10 0\n1 1 2 3 4 1 2 3 4 1 2\n"), "a.ele:1", "10 corners", "3");
    EXPECT_REFUSED(parsed("1 4 0 0\n0 0 0 0 0\n", ele), "a.node:1", "dimension 4", "2", "3");
    EXPECT_REFUSED(parsed("1 3 0 0\n2 0 0 0\n", ele), "a.node:2", "vertex", "2", "0", "1");
    EXPECT_REFUSED(parsed("2 3 0 0\n1 0 0 0\n3 0 0 0\n", ele), "a.node:3", "vertex", "3", "2");
    EXPECT_REFUSED(parsed("1 3 0 0\n1 0 inf 0\n", ele), "a.node:2", "vertex 0", "coordinate",
                   "NaN");
    EXPECT_REFUSED(parsed("1 3 0 0\n1 0 0\n", ele), "a.node:2", "line ends", "vertex");
    EXPECT_REFUSED(parsed(nodes, "1 4 0\n1 1 2 3 6\n"), "a.ele:2", "vertex", "6", "range", "1",
                   "5");
    EXPECT_REFUSED(parsed(nodes, "1 4 0\n1 1 2 3 4 5\n"), "a.ele:2", "5", "line", "cell");
    EXPECT_REFUSED(parsed(nodes + "6 0 0 0 0 0 0\n", ele), "a.node:9", "5 vertices", "end");
    EXPECT_REFUSED(parsed(nodes, "1 4 0\n1 1 2 3 4\n2 2 3 4 5\n"), "a.ele:3", "1 cells", "end");
    EXPECT_REFUSED(parsed(nodes, "2000000000 4 0\n1 1 2 3 4\n"), "a.ele:1", "2000000000 cells",
                   "11 bytes", "10 bytes");
}

} // namespace polydec::test::in_tetgen
