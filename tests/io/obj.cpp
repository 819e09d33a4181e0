// SPDX-License-Identifier: MIT
#include "tests/io/support.h"

#include <gtest/gtest.h>

namespace polydec::tests {

namespace {

using Cells = std::vector<std::vector<Index>>;

const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const Cells two_triangles{{0, 1, 2}, {0, 2, 3}};

} // namespace

TEST(Obj, CornersMayHaveTextureAndNormal) {
    for (const std::string faces :
         {"f 1 2 3\nf 1 3 4\n", "f 1/5 2/6 3/7\nf 1/5 3/7 4/8\n", "f 1//1 2//1 3//1\nf 1// 3// 4//",
          "f 1/1/1 2/2/2 3/3/3 # face\nf 1/ 3/ 4/\n", "f\t1 2   3 \n  f 1 3 4"}) {
        const auto mesh = read_from("a.obj", vertices + "vt 0 0\nvn 0 0 1\n" + faces);
        EXPECT_EQ(rows(mesh.simplices), two_triangles) << faces;
        EXPECT_TRUE(mesh.warnings.empty());
    }
}

TEST(Obj, NegativeIndicesCountBack) {
    const auto mesh = read_from("a.obj", vertices + "f -4 -3/1 -2//1\nv 5 5 5\nf -5 -3 -2\n");
    EXPECT_EQ(rows(mesh.simplices), two_triangles);
}

TEST(Obj, LinesMayBeContinued) {
    for (const std::string line_break : {"\n", "\r\n", "\r"}) {
        const auto text = with_line_breaks(
            vertices + "# comment \\\nf 1 2 \\\n 3\nf 1 \\\n\\\n3 4\\\n\nf 9 1 1\n", line_break);
        EXPECT_EQ(reading_error("a.obj", text),
                  "InvalidInput: a.obj:12: vertex number 9 is out of range; expected 1 to 4; "
                  "correct the index or add the vertex");
        const auto mesh = read_from("a.obj", text.substr(0, text.size() - 6 - line_break.size()));
        EXPECT_EQ(rows(mesh.simplices), two_triangles);
    }
}

TEST(Obj, FacesMayComeBeforeTheirVertices) {
    EXPECT_EQ(rows(read_from("a.obj", "f 1 2 3\nf 1 3 4\n" + vertices).simplices), two_triangles);
    EXPECT_EQ(
        reading_error("a.obj", "f 1 2 3\nf 1 5 4\n" + vertices),
        "InvalidInput: a.obj:2: vertex number 5 is out of range; expected 1 to 4; correct the "
        "index or add the vertex");
}

TEST(Obj, LeavesOutOtherRecordsAndExtraNumbers) {
    const auto mesh = read_from(
        "a.obj", "mtllib a.mtl\no x\nv 0 0 0 1 0 0\nv 1 0 0 1\nv 1 1 0 # c\nv 0 1 0\ng a\n"
                 "usemtl b\ns off\nvp 1 2\nf 1 2 3\nf 1 3 4\n");
    EXPECT_EQ(rows(mesh.simplices), two_triangles);
    EXPECT_TRUE(mesh.warnings.empty());
}

TEST(Obj, WarnsOfLinesPointsAndSmallFaces) {
    const auto mesh = read_from("a.obj", vertices + "l 1 2\np 1\nf 1 2\nf\nf 1 2 3 4\n");
    EXPECT_EQ(rows(mesh.simplices), two_triangles);
    EXPECT_EQ(
        mesh.warnings,
        (std::vector<std::string>{
            "2 faces with fewer than three corners left out, the first is face 0",
            "1 polygon with more than three corners split into triangles, the first is face 2",
            "2 records of lines or points left out, the first in line 5"}));
}

TEST(Obj, RefusesIndicesOutOfRange) {
    EXPECT_EQ(
        reading_error("a.obj", vertices + "f 1 0 3\n"),
        "InvalidInput: a.obj:5: vertex number 0 is out of range; expected 1 to 4; correct the "
        "index or add the vertex");
    EXPECT_EQ(reading_error("a.obj", vertices + "f 1 -5 3\n"),
              "InvalidInput: a.obj:5: vertex number -5 is out of range; expected -4 to -1 counted "
              "back from here; correct the index or add the vertex");
    EXPECT_EQ(reading_error("a.obj", vertices + "f 1 3000000000 3\n"),
              "InvalidInput: a.obj:5: vertex number 3000000000 is out of range; expected 1 to 4; "
              "correct the index or add the vertex");
    EXPECT_EQ(reading_error("a.obj", vertices + "f 1 two 3\n"),
              "InvalidInput: a.obj:5: 'two' is not a whole number; expected a vertex number; "
              "correct the line or export the file again");
}

TEST(Obj, RefusesVerticesWithTooFewCoordinates) {
    EXPECT_EQ(reading_error("a.obj", "v 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n"),
              "InvalidInput: a.obj:1: the line ends here; expected three coordinates of a vertex; "
              "complete the line");
}

TEST(Obj, RefusesFilesWithoutVerticesOrCells) {
    EXPECT_EQ(reading_error("a.obj", ""),
              "InvalidInput: a.obj: the file holds no vertices; expected a mesh; export it again");
    EXPECT_EQ(reading_error("a.obj", vertices + "f 1 2\n"),
              "InvalidInput: a.obj: the file holds 4 vertices but no cells; expected at least one "
              "cell; export it with its cells");
}

} // namespace polydec::tests
