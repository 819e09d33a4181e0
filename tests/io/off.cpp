// SPDX-License-Identifier: MIT
#include "tests/io/support.h"

namespace polydec::test::in_off {

using Cells = std::vector<std::vector<Index>>;

const std::string vertices = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
const std::string faces = "3 0 1 2\n3 0 2 3\n";
const Cells two_triangles{{0, 1, 2}, {0, 2, 3}};

TEST(Off, ReadsVerticesAndFaces) {
    const auto mesh = read_from("a.off", "OFF\n4 2 0\n" + vertices + faces);
    EXPECT_EQ(rows(mesh.points),
              (std::vector<std::vector<double>>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    EXPECT_EQ(rows(mesh.simplices), two_triangles);
    EXPECT_TRUE(mesh.warnings.empty());
}

TEST(Off, HeaderMayHaveManyShapes) {
    const std::string body = vertices + faces;
    for (const std::string header :
         {"OFF\n4 2 0\n", "OFF 4 2 0\n", "OFF4 2 0\n", "4 2 0\n", "\n# a\n\n OFF # b\n4\n2\n\n0\n",
          "off\n4 2 0\n", "\xEF\xBB\xBFOFF\n4 2 0\n"})
        EXPECT_EQ(rows(read_from("a.off", header + body).simplices), two_triangles) << header;
}

TEST(Off, LeavesOutNumbersBehindCoordinatesAndCorners) {
    const std::string colored = "0 0 0 255 0 0 255\n1 0 0 0 0 1\n1 1 0 1 1\n0 1 0 0.5\n";
    const std::string faces_colored = "3 0 1 2 255 0 0\n3 0 2 3 0.1 0.2 0.3 1\n";
    for (const std::string keyword : {"OFF", "COFF", "NOFF", "STOFF", "CNOFF", "STCNOFF"}) {
        const auto mesh = read_from("a.off", keyword + "\n4 2 0\n" + colored + faces_colored);
        EXPECT_EQ(rows(mesh.simplices), two_triangles) << keyword;
        EXPECT_EQ(mesh.points(2, 1), 1.0) << keyword;
    }
}

TEST(Off, OfFacesWithTwoCornersIsACurve) {
    const auto mesh = read_from("a.off", "OFF\n4 2 0\n" + vertices + "2 0 1\n2 1 3\n");
    EXPECT_EQ(rows(mesh.simplices), (Cells{{0, 1}, {1, 3}}));
    const auto mixed = read_from("a.off", "OFF\n4 2 0\n" + vertices + "2 0 1\n3 1 2 3\n");
    EXPECT_EQ(rows(mixed.simplices), (Cells{{1, 2, 3}}));
}

TEST(Off, FaceMayGoOverManyLines) {
    const auto mesh =
        read_from("a.off", "OFF\n4 2 0\n" + vertices + "3\n0\n\n1\n2\n# comment\n3 0\n 2 3");
    EXPECT_EQ(rows(mesh.simplices), two_triangles);
}

TEST(Off, LinesMayEndInThreeWays) {
    const std::string text = "OFF\n4 2 0\n" + vertices + faces;
    const std::string bad = "OFF\n4 2 0\n" + vertices + "3 0 1 2\n3 0 2 7\n";
    for (const std::string line_break : {"\n", "\r\n", "\r"}) {
        const auto mesh = read_from("a.off", with_line_breaks(text, line_break));
        EXPECT_EQ(rows(mesh.simplices), two_triangles);
        EXPECT_UNREADABLE("a.off", with_line_breaks(bad, line_break), "a.off:8", "vertex", "7",
                          "range", "0", "3");
    }
}

TEST(Off, NumbersMayBeWrittenInManyWays) {
    const auto mesh = read_from(
        "a.off", "OFF\n4 1 0\n1e-3 +1.5 .5\n-.5E+2 5. -0\n1e-400 4.9e-324 0.1\n0 0 7\n3 0 +1 2\n");
    EXPECT_EQ(rows(mesh.points),
              (std::vector<std::vector<double>>{
                  {1e-3, 1.5, 0.5}, {-50, 5, 0}, {0, 4.9e-324, 0.1}, {0, 0, 7}}));
}

TEST(Off, WarnsOfWhatFollowsTheFaces) {
    const auto mesh = read_from("a.off", "OFF\n4 1 0\n" + vertices + faces);
    EXPECT_EQ(mesh.simplices.rows(), 1);
    EXPECT_EACH_SAYS(mesh.warnings, {"left out", "1 faces", "line 8"});
}

TEST(Off, SplitsPolygonsAndLeavesOutSmallFaces) {
    const auto mesh = read_from("a.off", "OFF\n4 3 0\n" + vertices + "2 0 1\n4 0 1 2 3\n1 0\n");
    EXPECT_EQ(rows(mesh.simplices), two_triangles);
    EXPECT_EACH_SAYS(mesh.warnings, {"2 faces", "three corners", "face 0"},
                     {"1 polygon", "triangles", "face 1"});
}

TEST(Off, KeepsTrianglesThatLaterChecksJudge) {
    const auto mesh =
        read_from("a.off", "OFF\n4 4 0\n" + vertices + "3 0 1 2\n3 0 1 2\n3 0 2 2\n3 1 0 2\n");
    EXPECT_EQ(rows(mesh.simplices), (Cells{{0, 1, 2}, {0, 1, 2}, {0, 2, 2}, {1, 0, 2}}));
}

TEST(Off, RefusesOtherKeywords) {
    EXPECT_UNREADABLE("a.off", "nOFF\n0\n1 1 0\n", "a.off:2", "dimension 0", "1", "nOFF");
    EXPECT_UNREADABLE("a.off", "OFF BINARY\n1 1 0\n", "a.off:1", "binary");
    EXPECT_UNREADABLE("a.off", "solid\x01 text\n", "a.off:1", "solid?", "OFF");
    EXPECT_UNREADABLE("a.off", std::string(50, 'x'), "a.off:1", std::string(40, 'x') + "...",
                      "OFF");
}

TEST(Off, RefusesWhatIsNoNumber) {
    for (const std::string word : {"abc", "1.#INF", "1,5", "0x10", "1e", "+-1", "--1", "-", "+"}) {
        EXPECT_UNREADABLE("a.off", "OFF\n3 1 0\n0 0 " + word + "\n0 1 0\n1 0 0\n3 0 1 2\n",
                          "a.off:3", word, "number", "coordinate");
    }
    for (const std::string word : {"1.0", "x", "1e0"}) {
        EXPECT_UNREADABLE("a.off", "OFF\n3 1 0\n0 0 0\n0 1 0\n1 0 0\n3 0 1 " + word + "\n",
                          "a.off:6", word, "whole number", "vertex");
    }
    EXPECT_UNREADABLE("a.off", "OFF\n3 4\n0.1 0.2 0.3\n2\r20\n4\n", "a.off:3", "0.1",
                      "whole number", "edges");
    EXPECT_UNREADABLE("a.off", "OFF\n99999999999999999999 1 0\n", "a.off:2", "99999999999999999999",
                      "large", "vertices");
}

TEST(Off, RefusesAThirdCoordinateAfterVerticesOfTwo) {
    EXPECT_UNREADABLE("a.off", "OFF\n3 1 0\n0 0\n1 0\n0.5 1 7\n3 0 1 2\n", "a.off:5", "7", "line",
                      "two coordinates");
}

TEST(Off, RefusesCoordinatesThatAreNotFinite) {
    for (const std::string word :
         {"nan", "-NaN", "inf", "+Inf", "-infinity", "1e400", "-1e999999"}) {
        EXPECT_UNREADABLE("a.off", "OFF\n3 1 0\n0 0 0\n0 1 " + word + "\n1 0 0\n3 0 1 2\n",
                          "a.off:4", "vertex 1", "coordinate", "NaN");
    }
}

TEST(Off, RefusesMoreThanTheFileCanHold) {
    EXPECT_UNREADABLE("a.off", "OFF\n3 4000000000 0\n0 0 0\n0 1 0\n1 0 0\n3 0 1 2\n", "a.off:2",
                      "4000000000 faces", "29 bytes", "2 bytes");
    EXPECT_UNREADABLE("a.off", "OFF\n3 1 0\n0 0 0\n0 1 0\n1 0 0\n2000000000 0 1 2\n", "a.off:6",
                      "2000000000 corners", "face", "7 bytes", "2 bytes");
}

} // namespace polydec::test::in_off
