// SPDX-License-Identifier: MIT
#include "tests/io/support.h"

namespace polydec::test::in_length_file {

LengthMesh lengths_from(const std::string& text) {
    const TemporaryFolder folder;
    return read_lengths(folder.write("a.nsl", text));
}

const std::string triangle = "0 1 2\n0 1 3\n0 2 4\n1 2 5\n";

TEST(LengthFile, HoldsSimplicesAndLengthsWithComments) {
    const auto mesh = lengths_from("# flat\n2 4 2 5 # n V S E\n\n0 1 2\n0 2 3\n"
                                   "2 1 1\n0 1 1e0 # one\n0 2 1.4142135623730951\n3 2 1\n3 0 .5\n");
    EXPECT_EQ(mesh.dimension(), 2);
    EXPECT_EQ(mesh.vertices, 4);
    EXPECT_EQ(rows(mesh.simplices), (std::vector<std::vector<Index>>{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_EQ(rows(mesh.edges),
              (std::vector<std::vector<Index>>{{2, 1}, {0, 1}, {0, 2}, {3, 2}, {3, 0}}));
    EXPECT_EQ(mesh.lengths[2], 1.4142135623730951);
    EXPECT_EQ(mesh.lengths[4], 0.5);
}

TEST(LengthFile, WrittenAndReadIsTheSameToTheLastBit) {
    const TemporaryFolder folder;
    for (const auto& [name, with_points] : test::meshes()) {
        const auto mesh = length_mesh(with_points);
        write_lengths(folder.path("b.nsl"), mesh);
        const auto again = read_lengths(folder.path("b.nsl"));
        EXPECT_EQ(again.vertices, mesh.vertices) << name;
        EXPECT_TRUE(again.simplices == mesh.simplices) << name;
        EXPECT_TRUE(again.edges == mesh.edges) << name;
        EXPECT_TRUE(again.lengths == mesh.lengths) << name;
    }
}

TEST(LengthFile, WrittenWithSixDigitsWouldNotBeTheSame) {
    const auto text = std::to_string(std::sqrt(2.0));
    EXPECT_NE(lengths_from("1 2 1 1\n0 1\n0 1 " + text + "\n").lengths[0], std::sqrt(2.0));
}

TEST(LengthFile, RefusesLinesThatDoNotFit) {
    EXPECT_REFUSED(lengths_from("0 3 1 3\n" + triangle), "a.nsl:1", "dimension 0", "1");
    EXPECT_REFUSED(lengths_from("2 3 1 3 7\n" + triangle), "a.nsl:1", "7", "line", "n V S E");
    EXPECT_REFUSED(lengths_from("2 3 1 3\n0 1\n0 1 3\n0 2 4\n1 2 5\n"), "a.nsl:2", "line ends",
                   "simplex", "3");
    EXPECT_REFUSED(lengths_from("2 3 1 3\n0 1 3\n0 1 3\n0 2 4\n1 2 5\n"), "a.nsl:2", "vertex", "3",
                   "range", "0", "2");
    EXPECT_REFUSED(lengths_from("2 3 1 3\n0 1 2\n0 1\n0 2 4\n1 2 5\n"), "a.nsl:3", "line ends",
                   "edge");
    EXPECT_REFUSED(lengths_from("2 3 1 3\n0 1 2\n0 1 x\n0 2 4\n1 2 5\n"), "a.nsl:3", "x", "number",
                   "length");
    EXPECT_REFUSED(lengths_from("2 3 1 3\n0 1 2\n0 1 3\n0 2 -4\n1 2 5\n"), "a.nsl:4", "edge 0 2",
                   "length", "-4");
    EXPECT_REFUSED(lengths_from("2 3 1 3\n0 1 2\n0 1 3\n0 2 inf\n1 2 5\n"), "a.nsl:4", "edge 0 2",
                   "length", "inf");
    EXPECT_REFUSED(lengths_from("2 3 1 3\n" + triangle + "0 1 3\n"), "a.nsl:6", "3 edges", "end");
    EXPECT_REFUSED(lengths_from("2 3 1 2000000000\n0 1 2\n0 1 3\n"), "a.nsl:1", "2000000000 edges",
                   "13 bytes", "6 bytes");
    EXPECT_REFUSED(lengths_from("2 3 0 0\n      "), "a.nsl: ", "no simplices");
}

TEST(LengthFile, RefusesEdgesThatAreNotThereExactlyOnce) {
    EXPECT_REFUSED(lengths_from("2 3 1 3\n0 1 2\n0 1 3\n# c\n1 0 4\n1 2 5\n"), "a.nsl:5",
                   "edge 0 1", "line 3");
    EXPECT_REFUSED(lengths_from("2 4 1 4\n0 1 2\n0 1 3\n0 2 4\n3 2 1\n1 2 5\n"), "a.nsl:5",
                   "edge 2 3", "simplex");
    EXPECT_REFUSED(lengths_from("2 3 1 2\n0 1 2\n0 1 3\n1 2 5\n"), "a.nsl: ", "edge 0 2", "length");
}

TEST(LengthFile, IsNoMeshWithPoints) {
    EXPECT_REFUSED(read_mesh("a.nsl"), "a.nsl: ", ".nsl", "no points");
    EXPECT_REFUSED(read_lengths("a.nsc"), "a.nsc: ", "lengths", ".nsl");
    EXPECT_REFUSED(check_drawable(2, 0), "lengths", "drawing", "points");
}

TEST(LengthFile, IsWrittenOfWhatCanBeReadAlone) {
    auto mesh = lengths_from("2 3 1 3\n" + triangle);
    EXPECT_REFUSED(write_lengths("a.off", mesh), "a.off", "lengths", ".nsl");
    mesh.lengths[1] = 0;
    EXPECT_REFUSED(write_lengths("a.nsl", mesh), "a.nsl", "edge 1", "vertices 0", "2", "length 0");
    mesh.lengths[1] = 4;
    mesh.edges(1, 0) = 1;
    EXPECT_REFUSED(write_lengths("a.nsl", mesh), "edge", "vertices 0", "2", "length");
}

} // namespace polydec::test::in_length_file
