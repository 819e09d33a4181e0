// SPDX-License-Identifier: MIT
#include "io/meshes/readers.h"
#include "tests/io/support.h"

#include <gtest/gtest.h>

namespace polydec::tests {

namespace {

using Cells = std::vector<std::vector<Index>>;

const std::string nodes = "# made by hand\n5 3 2 1\n1 0 0 0 0.5 0.5 1\n2 1 0 0 0 0 0\n"
                          "3 0 1 0 0 0 0 # a corner\n\n4 0 0 1 0 0 0\n5 1 1 1.25 0 0 0\n";
const std::string nodes_from_zero = "5 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n3 0 0 1\n4 1 1 1.25\n";
const std::string planar = "4 2 0 1\n1 0 0 1\n2 1 0 1\n3 1 1 1\n4 0 1 1\n";

Mesh parsed(const std::string& node, const std::string& ele) {
    return parse_tetgen({"a.node", node}, {"a.ele", ele});
}

std::string parsing_error(const std::string& node, const std::string& ele) {
    return error_of([&] { parsed(node, ele); });
}

} // namespace

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
}

TEST(TetGen, NeighborsOfFacesAreLeftOut) {
    const auto mesh = parse_tetgen({"a.node", nodes}, {"a.face", "1 1\n1 1 2 3 0 17 -1\n"});
    EXPECT_EQ(rows(mesh.simplices), (Cells{{0, 1, 2}}));
    EXPECT_TRUE(mesh.tags.empty());
}

TEST(TetGen, SaysWhichFileIsMissing) {
    const TemporaryFolder folder;
    const auto node = folder.write("a.node", nodes);
    EXPECT_EQ(error_of([&] { read_mesh(node); }),
              "InvalidInput: " + node.string() + ": neither " + folder.path("a.ele").string() +
                  " nor .face is beside it; expected the file of the cells; put it there");
    const auto ele = folder.write("b.ele", "1 4 0\n1 1 2 3 4\n");
    EXPECT_EQ(error_of([&] { read_mesh(ele); }), "IoError: cannot read " +
                                                     folder.path("b.node").string() +
                                                     ": No such file or directory");
}

TEST(TetGen, RefusesWhatDoesNotFit) {
    const std::string ele = "1 4 0\n1 1 2 3 4\n";
    EXPECT_EQ(parsing_error(nodes, "1 10 0\n1 1 2 3 4 1 2 3 4 1 2\n"),
              "InvalidInput: a.ele:1: cells of 10 corners; expected 4, the corners of linear "
              "simplices; run TetGen or Triangle without the option -o2");
    EXPECT_EQ(parsing_error(planar, "1 6 0\n1 1 2 3 4 1 2\n"),
              "InvalidInput: a.ele:1: cells of 6 corners; expected 3, the corners of linear "
              "simplices; run TetGen or Triangle without the option -o2");
    EXPECT_EQ(parsing_error("1 4 0 0\n0 0 0 0 0\n", ele),
              "InvalidInput: a.node:1: points of dimension 4; expected 2 or 3; write the mesh as "
              ".nsc");
    EXPECT_EQ(parsing_error("1 3 0 0\n2 0 0 0\n", ele),
              "InvalidInput: a.node:2: the first vertex has the number 2; expected 0 or 1; number "
              "them from there");
    EXPECT_EQ(parsing_error("2 3 0 0\n1 0 0 0\n3 0 0 0\n", ele),
              "InvalidInput: a.node:3: a vertex of the number 3; expected 2, for they must be "
              "numbered one by one; number them again");
    EXPECT_EQ(parsing_error("1 3 0 0\n1 0 inf 0\n", ele),
              "InvalidInput: a.node:2: vertex 0 (counted from 0) has a coordinate that is NaN, "
              "infinite or beyond the doubles; expected finite numbers; repair or remove the "
              "vertex");
    EXPECT_EQ(parsing_error("1 3 0 0\n1 0 0\n", ele),
              "InvalidInput: a.node:2: the line ends here; expected a vertex; complete the line");
    EXPECT_EQ(parsing_error(nodes, "1 4 0\n1 1 2 3 6\n"),
              "InvalidInput: a.ele:2: vertex number 6 is out of range; expected 1 to 5; correct "
              "the index or add the vertex");
    EXPECT_EQ(parsing_error(nodes, "1 4 0\n1 1 2 3 4 5\n"),
              "InvalidInput: a.ele:2: '5' follows on the same line; expected the end of a cell; "
              "correct the line or export the file again");
    EXPECT_EQ(parsing_error(nodes, "2000000000 4 0\n1 1 2 3 4\n"),
              "InvalidInput: a.ele:1: 2000000000 cells are promised, but 11 bytes follow; expected "
              "at least 10 bytes for each; correct the number, or export again if the file was "
              "cut off");
}

TEST(TetGen, RealFilesAreReadWhole) {
    for (const char* name : {"tet/cube.1.node", "tet/cube.1.ele"}) {
        if (const auto path = test_datum(name)) {
            const auto mesh = read_mesh(*path);
            EXPECT_EQ(mesh.points.rows(), 4550);
            EXPECT_EQ(mesh.simplices.rows(), 20981);
            EXPECT_NEAR(volume(mesh), 1.0, 1e-12);
        }
    }
    if (const auto path = test_datum("tet/icos.1.ele")) {
        EXPECT_NEAR(volume(read_mesh(*path)), 17.45276404266667, 1e-12);
    }
}

} // namespace polydec::tests
