// SPDX-License-Identifier: MIT
#include "tests/io/support.h"

namespace polydec::test::in_stl {

using Cells = std::vector<std::vector<Index>>;
using Triangle = std::array<float, 9>;

std::string binary(const std::vector<Triangle>& triangles, std::string header = "any text") {
    header.resize(80, ' ');
    std::string text = header;
    const auto append = [&text](const auto& value) {
        text.append(reinterpret_cast<const char*>(&value), sizeof(value));
    };
    append(static_cast<std::uint32_t>(triangles.size()));
    for (const auto& triangle : triangles) {
        append(std::array<float, 3>{});
        append(triangle);
        append(std::uint16_t{0xFFFF});
    }
    return text;
}

std::string facet(const std::string& a, const std::string& b, const std::string& c) {
    return "facet normal 0 0 nan\n outer loop\n  vertex " + a + "\n  vertex " + b + "\n  vertex " +
           c + "\n endloop\nendfacet\n";
}

const std::vector<Triangle> square{{0, 0, 0, 1, 0, 0, 1, 1, 0}, {-0.F, 0, -0.F, 1, 1, 0, 0, 1, 0}};
const std::string square_text = "solid a b c\n" + facet("0 0 0", "1 0 0", "1 1 0") +
                                facet("-0 0 -0.0", "1 1.0 0", "0 1 0") + "endsolid a b c\n";

TEST(Stl, JoinsEqualVerticesInOrderOfAppearance) {
    for (const auto& text : {binary(square), binary(square, "solid but binary"), square_text}) {
        const auto mesh = read_from("a.stl", text);
        EXPECT_EQ(rows(mesh.points),
                  (std::vector<std::vector<double>>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
        EXPECT_EQ(rows(mesh.simplices), (Cells{{0, 1, 2}, {0, 2, 3}}));
    }
}

TEST(Stl, DoesNotJoinVerticesThatDiffer) {
    const float next = std::nextafter(1.F, 2.F);
    const auto mesh = read_from("a.stl", binary({square[0], {0, 0, 0, next, 1, 0, 0, 1, 0}}));
    EXPECT_EQ(mesh.points.rows(), 5);
}

TEST(Stl, JoinsWhatIsOffByARoundingAndTellsHowMany) {
    const auto mesh =
        read_from("a.stl", "solid\n" + facet("0 0 0", "1 0 0", "1 1 0") +
                               facet("0 1.2246e-16 0", "1 1 -1e-17", "0 1 0") + "endsolid");
    EXPECT_EQ(rows(mesh.simplices), (Cells{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_EACH_SAYS(mesh.warnings, {"joined 2 corners", "1.41e-09", "1e-9"});
    EXPECT_TRUE(read_from("a.stl", square_text).warnings.empty());
}

TEST(Stl, TextMayHaveCapitalsAndSeveralSolids) {
    auto capitals = square_text;
    for (char& c : capitals)
        c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
    EXPECT_EQ(read_from("a.STL", capitals).simplices.rows(), 2);
    EXPECT_EQ(
        read_from("a.stl", square_text + "solid\n" + facet("0 0 0", "0 0 1", "1 0 0") + "endsolid")
            .simplices.rows(),
        3);
}

TEST(Stl, KeepsFacetsThatLaterChecksJudge) {
    const auto mesh = read_from("a.stl", binary({square[0], square[0], {}}));
    EXPECT_EQ(rows(mesh.simplices), (Cells{{0, 1, 2}, {0, 1, 2}, {0, 0, 0}}));
}

/// A triangle of any size reads back with three corners, or is refused.
TEST(Stl, RefusesToWriteCornersThatFloatsDoNotTellApart) {
    const TemporaryFolder folder;
    for (const double size : {1e-60, 1e-6, 1e-3, 1.0})
        for (const double place : {0.0, 1.0, 1e5}) {
            Mesh mesh;
            mesh.points = place + size * Points::Identity(3, 3).array();
            mesh.simplices = Simplices{{2, 0, 1}};
            const auto path = folder.path("a.stl");
            if (place + size == place)
                continue; // nor do doubles
            const bool fits = size > 1e-30 && size > 1e-7 * place;
            if (fits) {
                write_mesh(path, mesh);
                EXPECT_EQ(read_mesh(path).points.rows(), 3) << size << " " << place;
            } else {
                EXPECT_REFUSED(write_mesh(path, mesh), path.string(), "vertices 2 and 0", ".ply");
            }
        }
}

TEST(Stl, RefusesWhatIsCutOff) {
    const auto text = binary(square);
    EXPECT_UNREADABLE("a.stl", text.substr(0, 180), "a.stl: ", "180 bytes", "184", "2 triangles");
    EXPECT_UNREADABLE("a.stl", binary(square, "solid").substr(0, 180), "a.stl: ", "180 bytes",
                      "184", "2 triangles");
    EXPECT_UNREADABLE("a.stl", text.substr(0, 80), "a.stl: ", "80 bytes", "84");
    EXPECT_UNREADABLE("a.stl", "solid a\n" + facet("0 0 0", "1 0 0", "1 1 0"), "a.stl:9",
                      "file ends", "facet");
    EXPECT_UNREADABLE("a.stl", binary({}), "a.stl: ", "no vertices");
}

TEST(Stl, RefusesWhatDoesNotFit) {
    EXPECT_UNREADABLE("a.stl",
                      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n"
                      "vertex 0 0 0\nendloop\n",
                      "a.stl:6", "endloop", "vertex");
    EXPECT_UNREADABLE("a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 inf\n",
                      "a.stl:4", "vertex 0", "coordinate", "NaN");
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_UNREADABLE("a.stl", binary({square[0], {0, 0, 0, 1, nan, 0, 0, 1, 0}}),
                      "a.stl: ", "corner 1", "triangle 1", "coordinate", "NaN");
}

} // namespace polydec::test::in_stl
