// SPDX-License-Identifier: MIT
#include "io/meshes/length_file.h"

#include "io/pictures/draw_cells.h"
#include "tests/io/support.h"
#include "tests/support/families.h"

#include <gtest/gtest.h>

#include <cmath>

namespace polydec::tests {

namespace {

LengthMesh lengths_from(const std::string& text) {
    const TemporaryFolder folder;
    return read_lengths(folder.write("a.nsl", text));
}

/// Without the folder in front of the file's name.
std::string lengths_error(const std::string& text) {
    const TemporaryFolder folder;
    auto error = error_of([&] { read_lengths(folder.write("a.nsl", text)); });
    const auto place = error.find(folder.path().string());
    return place == std::string::npos ? error
                                      : error.erase(place, folder.path().string().size() + 1);
}

const std::string triangle = "0 1 2\n0 1 3\n0 2 4\n1 2 5\n";

} // namespace

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
    EXPECT_EQ(lengths_error("0 3 1 3\n" + triangle),
              "InvalidInput: a.nsl:1: dimension 0; expected at least 1; the first line is n V S E: "
              "dimension and numbers of vertices, simplices and edges");
    EXPECT_EQ(lengths_error("2 3 1 3 7\n" + triangle),
              "InvalidInput: a.nsl:1: '7' follows on the same line; expected the end of the first "
              "line, n V S E: dimension and numbers of vertices, simplices and edges; correct the "
              "line or export the file again");
    EXPECT_EQ(lengths_error("2 3 1 3\n0 1\n0 1 3\n0 2 4\n1 2 5\n"),
              "InvalidInput: a.nsl:2: the line ends here; expected a simplex of 3 vertex numbers; "
              "complete the line");
    EXPECT_EQ(lengths_error("2 3 1 3\n0 1 3\n0 1 3\n0 2 4\n1 2 5\n"),
              "InvalidInput: a.nsl:2: vertex number 3 is out of range; expected 0 to 2; correct "
              "the index or add the vertex");
    EXPECT_EQ(lengths_error("2 3 1 3\n0 1 2\n0 1\n0 2 4\n1 2 5\n"),
              "InvalidInput: a.nsl:3: the line ends here; expected an edge: two vertex numbers and "
              "a length; complete the line");
    EXPECT_EQ(lengths_error("2 3 1 3\n0 1 2\n0 1 x\n0 2 4\n1 2 5\n"),
              "InvalidInput: a.nsl:3: 'x' is not a number; expected a length; correct the line or "
              "export the file again");
    EXPECT_EQ(lengths_error("2 3 1 3\n0 1 2\n0 1 3\n0 2 -4\n1 2 5\n"),
              "InvalidInput: a.nsl:4: edge 0 2 has length -4; expected a finite number above 0; "
              "correct it");
    EXPECT_EQ(lengths_error("2 3 1 3\n0 1 2\n0 1 3\n0 2 inf\n1 2 5\n"),
              "InvalidInput: a.nsl:4: edge 0 2 has length inf; expected a finite number above 0; "
              "correct it");
    EXPECT_EQ(lengths_error("2 3 1 3\n" + triangle + "0 1 3\n"),
              "InvalidInput: a.nsl:6: more follows after 3 edges; expected the end of the file; "
              "correct the number in the first line");
    EXPECT_EQ(lengths_error("2 3 1 2000000000\n0 1 2\n0 1 3\n"),
              "InvalidInput: a.nsl:1: 2000000000 edges are promised, but 13 bytes follow; expected "
              "at least 6 bytes for each; correct the number, or export again if the file was cut "
              "off");
    EXPECT_EQ(lengths_error("2 3 0 0\n      "),
              "InvalidInput: a.nsl: the file holds no simplices; expected at least one; write it "
              "again");
}

TEST(LengthFile, RefusesEdgesThatAreNotThereExactlyOnce) {
    EXPECT_EQ(lengths_error("2 3 1 3\n0 1 2\n0 1 3\n# c\n1 0 4\n1 2 5\n"),
              "InvalidInput: a.nsl:5: edge 0 1 has a length on line 3 already; expected every edge "
              "once; remove one of the two");
    EXPECT_EQ(lengths_error("2 4 1 4\n0 1 2\n0 1 3\n0 2 4\n3 2 1\n1 2 5\n"),
              "InvalidInput: a.nsl:5: edge 2 3 belongs to no simplex; expected edges of the "
              "simplices; remove the line or correct its vertices");
    EXPECT_EQ(lengths_error("2 3 1 2\n0 1 2\n0 1 3\n1 2 5\n"),
              "InvalidInput: a.nsl: edge 0 2 of the simplices has no length; expected every edge "
              "once; add a line for it");
}

TEST(LengthFile, IsNoMeshWithPoints) {
    EXPECT_EQ(error_of([] { read_mesh("a.nsl"); }),
              "InvalidInput: a.nsl: .nsl holds lengths of edges and no points; expected a mesh "
              "with points; read it with read_lengths");
    EXPECT_EQ(error_of([] { read_lengths("a.nsc"); }),
              "InvalidInput: a.nsc: lengths of edges are read from .nsl; expected this extension; "
              "rename the file, or read it with read_mesh");
    EXPECT_EQ(error_of([] { check_drawable(2, 0); }),
              "InvalidInput: only lengths are known, there are no points, which a drawing needs: "
              "give a mesh with points");
}

TEST(LengthFile, IsWrittenOfWhatCanBeReadAlone) {
    auto mesh = lengths_from("2 3 1 3\n" + triangle);
    EXPECT_EQ(error_of([&] { write_lengths("a.off", mesh); }),
              "InvalidInput: cannot write a.off: lengths of edges go to a file with the extension "
              ".nsl");
    mesh.lengths[1] = 0;
    EXPECT_EQ(error_of([&] { write_lengths("a.nsl", mesh); }),
              "InvalidInput: cannot write a.nsl: edge 1 with vertices 0 and 2 has length 0; "
              "expected a finite number above 0");
    mesh.lengths[1] = 4;
    mesh.edges(1, 0) = 1;
    EXPECT_EQ(error_of([&] { write_lengths("a.nsl", mesh); }),
              "InvalidInput: the edge with vertices 0 and 2 has no length: add it");
}

} // namespace polydec::tests
