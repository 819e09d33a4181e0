// SPDX-License-Identifier: MIT
#include "tests/io/support.h"

namespace polydec::test::in_obj {

using Cells = std::vector<std::vector<Index>>;

const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const Cells two_triangles{{0, 1, 2}, {0, 2, 3}};

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
        EXPECT_UNREADABLE("a.obj", text, "a.obj:12", "vertex", "9", "range", "1", "4");
        const auto mesh = read_from("a.obj", text.substr(0, text.size() - 6 - line_break.size()));
        EXPECT_EQ(rows(mesh.simplices), two_triangles);
    }
}

TEST(Obj, FacesMayComeBeforeTheirVertices) {
    EXPECT_EQ(rows(read_from("a.obj", "f 1 2 3\nf 1 3 4\n" + vertices).simplices), two_triangles);
    EXPECT_UNREADABLE("a.obj", "f 1 2 3\nf 1 5 4\n" + vertices, "a.obj:2", "vertex", "5", "range",
                      "1", "4");
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
    EXPECT_EACH_SAYS(mesh.warnings, {"2 faces", "three corners", "face 0"},
                     {"1 polygon", "triangles", "face 2"}, {"2 records", "lines", "line 5"});
}

TEST(Obj, OfLinesAloneIsACurve) {
    const auto mesh = read_from("a.obj", vertices + "l 1 2/1 3\nl -1 1\np 2\n");
    EXPECT_EQ(rows(mesh.simplices), (Cells{{0, 1}, {1, 2}, {3, 0}}));
    EXPECT_EACH_SAYS(mesh.warnings, {"1 record", "points", "line 7"});
    EXPECT_UNREADABLE("a.obj", vertices + "l 1 2 5\n", "a.obj:5", "vertex", "5", "range");
}

TEST(Obj, RefusesIndicesOutOfRange) {
    EXPECT_UNREADABLE("a.obj", vertices + "f 1 0 3\n", "a.obj:5", "vertex", "0", "range", "1", "4");
    EXPECT_UNREADABLE("a.obj", vertices + "f 1 -5 3\n", "a.obj:5", "vertex", "-5", "range", "-4",
                      "-1");
    EXPECT_UNREADABLE("a.obj", vertices + "f 1 3000000000 3\n", "a.obj:5", "vertex", "3000000000",
                      "range", "1", "4");
    EXPECT_UNREADABLE("a.obj", vertices + "f 1 two 3\n", "a.obj:5", "two", "whole number",
                      "vertex");
}

TEST(Obj, RefusesVerticesWithOtherNumbersOfCoordinates) {
    EXPECT_UNREADABLE("a.obj", "v 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n", "a.obj:2", "two coordinates",
                      "first vertex");
    EXPECT_UNREADABLE("a.obj", "v 0 0 0\nv 1 0\nv 1 1 0\nf 1 2 3\n", "a.obj:2", "line ends",
                      "coordinates");
}

TEST(Obj, RefusesCoordinatesThatAreNotFinite) {
    EXPECT_UNREADABLE("a.obj", "v inf nan +inf\nv nan -nan -Inf\nv 3 NaN -NaN\n\nf 1 2 3\n",
                      "a.obj:1", "vertex 0", "coordinate", "NaN");
}

TEST(Obj, RefusesFilesWithoutVerticesOrCells) {
    EXPECT_UNREADABLE("a.obj", "", "a.obj: ", "no vertices");
    EXPECT_UNREADABLE("a.obj", vertices + "f 1 2\n", "a.obj: ", "4 vertices", "no cells");
}

} // namespace polydec::test::in_obj
