// SPDX-License-Identifier: MIT
#include "io/meshes/readers.h"
#include "tests/io/bytes.h"
#include "tests/io/support.h"

namespace polydec::test::in_vtk {

using Cells = std::vector<std::vector<Index>>;

/// Writes parts of a file as text, or with the highest byte first.
class Writer {
public:
    Writer(bool is_binary, const std::string& version, const std::string& kind)
        : is_binary_(is_binary) {
        text_ = "# vtk DataFile Version " + version + "\nA title, maybe with POINTS 3 float\n" +
                (is_binary ? "BINARY" : "ASCII") + "\nDATASET " + kind + "\n";
    }

    Writer& line(const std::string& text) {
        text_ += text + "\n";
        return *this;
    }

    template <typename Number>
    Writer& numbers(const std::vector<double>& values) {
        if (is_binary_)
            text_ += bytes_of_all<Number>(values, std::endian::big);
        for (std::size_t i = 0; !is_binary_ && i < values.size(); ++i)
            text_ += std::to_string(values[i]) + (i % 3 == 2 ? "\n" : " ");
        text_ += "\n";
        return *this;
    }

    const std::string& text() const { return text_; }

private:
    bool is_binary_;
    std::string text_;
};

const std::vector<double> places{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1.25};

/// Two tetrahedra and a boundary triangle between them.
std::string grid(bool is_binary, const std::string& version) {
    Writer writer(is_binary, version, "UNSTRUCTURED_GRID");
    writer.line("FIELD FieldData 1").line("TIME 1 1 double").numbers<double>({0.5});
    writer.line("POINTS 5 float").numbers<float>(places);
    if (version[0] == '5') {
        writer.line("METADATA").line("INFORMATION 1").line("NAME X LOCATION Y").line("DATA 1 2\n");
        writer.line("CELLS 4 11").line("OFFSETS vtktypeint64");
        writer.numbers<std::int64_t>({0, 4, 7, 11}).line("CONNECTIVITY vtktypeint64");
        writer.numbers<std::int64_t>({0, 1, 2, 3, 0, 1, 2, 1, 2, 3, 4});
    } else {
        writer.line("CELLS 3 14");
        writer.numbers<std::int32_t>({4, 0, 1, 2, 3, 3, 0, 1, 2, 4, 1, 2, 3, 4});
    }
    writer.line("CELL_TYPES 3").numbers<std::int32_t>({10, 5, 10});
    writer.line("POINT_DATA 5").line("SCALARS material double 2").line("LOOKUP_TABLE default");
    writer.numbers<double>({1, 2, 3, 4, 5, 6, 7, 8, 9, 10}).line("NORMALS n float");
    writer.numbers<float>(places).line("CELL_DATA 3").line("SCALARS q unsigned_char 1");
    writer.line("LOOKUP_TABLE t").numbers<std::uint8_t>({1, 2, 3});
    writer.line("FIELD FieldData 2").line("speed 3 3 float");
    writer.numbers<float>({1, 2, 3, 4, 5, 6, 7, 8, 9}).line("METADATA").line("INFORMATION 0\n");
    return writer.line("CellEntityIds 1 3 int").numbers<std::int32_t>({11, 40, 12}).text();
}

std::string poly_data(bool is_binary, const std::string& version) {
    Writer writer(is_binary, version, "POLYDATA");
    writer.line("POINTS 5 double").numbers<double>(places);
    if (version[0] == '5') {
        writer.line("POLYGONS 3 7").line("OFFSETS vtktypeint64").numbers<std::int64_t>({0, 3, 7});
        writer.line("CONNECTIVITY vtktypeint64");
        writer.numbers<std::int64_t>({2, 1, 0, 0, 1, 4, 2});
        writer.line("LINES 2 2").line("OFFSETS vtktypeint64").numbers<std::int64_t>({0, 2});
        writer.line("CONNECTIVITY vtktypeint64").numbers<std::int64_t>({0, 3});
    } else {
        writer.line("POLYGONS 2 9").numbers<std::int32_t>({3, 2, 1, 0, 4, 0, 1, 4, 2});
        writer.line("LINES 1 3").numbers<std::int32_t>({2, 0, 3});
    }
    writer.line("CELL_DATA 3").line("SCALARS material int").line("LOOKUP_TABLE default");
    return writer.numbers<std::int32_t>({5, 6, 7}).text();
}

std::string small(const std::string& cells) {
    return "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 float\n"
           "0 0 0 1 0 0 0 1 0 1 1 0\n" +
           cells;
}

std::string one_cell(int type, const std::string& corners, int count) {
    return small("CELLS 1 " + std::to_string(count + 1) + "\n" + std::to_string(count) + " " +
                 corners + "\nCELL_TYPES 1\n" + std::to_string(type) + "\n");
}

TEST(Vtk, TextAndBytesOfOldAndNewVersionsAreTheSame) {
    for (const char* version : {"2.0", "3.0", "4.2", "5.1"}) {
        for (const bool is_binary : {false, true}) {
            const auto mesh = parse_mesh({"a.vtk", grid(is_binary, version)});
            EXPECT_EQ(rows(mesh.points),
                      (std::vector<std::vector<double>>{
                          {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1.25}}));
            expect_two_tetrahedra(mesh);
        }
    }
}

TEST(Vtk, PolygonsAreSplitAndTheirTagsFollowThatOfLines) {
    for (const char* version : {"3.0", "5.1"}) {
        for (const bool is_binary : {false, true}) {
            const auto mesh = parse_mesh({"a.vtk", poly_data(is_binary, version)});
            EXPECT_EQ(rows(mesh.simplices), (Cells{{2, 1, 0}, {0, 1, 4}, {0, 4, 2}}));
            EXPECT_EQ(mesh.tags, (std::vector<Index>{6, 7, 7}));
            EXPECT_EQ(rows(mesh.facet_tags.simplices), (Cells{{0, 3}}));
            EXPECT_EQ(mesh.facet_tags.tags, (std::vector<Index>{5}));
        }
    }
}

TEST(Vtk, StripsPixelsAndPolylinesBecomeTrianglesQuadsAndEdges) {
    const auto cells = [](const std::string& text) {
        return rows(read_from("a.vtk", text).simplices);
    };
    EXPECT_EQ(cells(one_cell(6, "0 1 2 3", 4)), (Cells{{0, 1, 2}, {1, 3, 2}}));
    EXPECT_EQ(cells(one_cell(8, "0 1 2 3", 4)), (Cells{{0, 1, 3}, {0, 3, 2}}));
    EXPECT_EQ(cells(one_cell(9, "0 1 3 2", 4)), (Cells{{0, 1, 3}, {0, 3, 2}}));
    EXPECT_EQ(cells(one_cell(4, "0 1 3 2", 4)), (Cells{{0, 1}, {1, 3}, {3, 2}}));
    EXPECT_EQ(cells(one_cell(7, "0 1 3", 3)), (Cells{{0, 1, 3}}));
    // All triangles of a strip turn the same way: a surface of two has one area, not none.
    EXPECT_EQ(total_volume(read_from("a.vtk", one_cell(6, "0 1 2 3", 4))), 1.0);
}

TEST(Vtk, NumbersThatAreNotWholeAreNoTags) {
    const auto text = one_cell(5, "0 1 2", 3) + "CELL_DATA 1\nSCALARS material float\n"
                                                "LOOKUP_TABLE default\n";
    const auto mesh = read_from("a.vtk", text + "1.5\n");
    EXPECT_TRUE(mesh.tags.empty());
    EXPECT_EACH_SAYS(mesh.warnings, {"groups", "1 cell", "1.5"});
    for (const std::string pairs :
         {"CELL_DATA 2\nSCALARS material int", "CELL_DATA 1\nSCALARS material int 2"})
        EXPECT_EACH_SAYS(
            read_from("a.vtk", one_cell(5, "0 1 2", 3) + pairs + "\nLOOKUP_TABLE default\n4 5\n")
                .warnings,
            {"groups", "1 cell", "2 numbers"});
    for (const Index tag : {2, std::numeric_limits<Index>::min()})
        EXPECT_EQ(read_from("a.vtk", text + std::to_string(tag) + "\n").tags,
                  (std::vector<Index>{tag}));
}

TEST(Vtk, WarnsOfDataThatAreLeftOut) {
    const auto mesh =
        read_from("a.vtk", one_cell(5, "0 1 2", 3) + "CELL_DATA 1\nSCALARS names variant\n"
                                                     "LOOKUP_TABLE default\nx\n");
    EXPECT_EACH_SAYS(mesh.warnings, {"scalars", "line 12"});
}

TEST(Vtk, RefusesCellsOfOtherShapes) {
    const auto cell = [](int type, int count) {
        std::string corners;
        for (int i = 0; i < count; ++i)
            corners += std::to_string(i % 4) + " ";
        return one_cell(type, corners, count);
    };
    EXPECT_UNREADABLE("a.vtk", cell(12, 7), "a.vtk:7", "cell 0", "type 12", "7 corners");
    EXPECT_UNREADABLE("a.vtk", cell(24, 4), "a.vtk:7", "cell 0", "type 24", "4 corners");
    EXPECT_UNREADABLE("a.vtk", cell(72, 7), "a.vtk:7", "cell 0", "type 72", "7 corners");
    EXPECT_UNREADABLE("a.vtk", cell(42, 4), "a.vtk:7", "cell 0", "polyhedron", "type 42");
    EXPECT_UNREADABLE("a.vtk", cell(99, 4), "a.vtk:7", "cell 0", "type 99", "10", "5", "9", "3",
                      "4");
}

TEST(Vtk, RefusesWhatDoesNotFit) {
    const std::string start = "# vtk DataFile Version 3.0\nx\n";
    EXPECT_UNREADABLE("a.vtk", "# vtp DataFile Version 3.0\nx\nASCII\n", "a.vtk:1",
                      "# vtk DataFile Version");
    EXPECT_UNREADABLE("a.vtk", "# vtk DataFile Version 9.0\nx\nASCII\n", "a.vtk:1", "version 9",
                      "1", "5.1");
    EXPECT_UNREADABLE("a.vtk", start + "TEXT\n", "a.vtk:3", "text", "ASCII", "BINARY");
    EXPECT_UNREADABLE("a.vtk", start + "ASCII\nDATASET FIELD f 1\n", "a.vtk:4", "field",
                      "UNSTRUCTURED_GRID", "POLYDATA");
    EXPECT_UNREADABLE("a.vtk", small("NONSENSE 4\n"), "a.vtk:7", "nonsense", "POINTS");
    EXPECT_UNREADABLE("a.vtk", one_cell(10, "0 1 2 4", 4), "a.vtk:7", "cell 0", "vertex", "4", "0",
                      "3");
    EXPECT_UNREADABLE("a.vtk", one_cell(5, "0 1 2 3", 4), "a.vtk:7", "cell 0", "type 5",
                      "4 corners");
    EXPECT_UNREADABLE("a.vtk", small("CELLS 2 4\n3 0 1 2\nCELL_TYPES 2\n5 5\n"), "a.vtk:7",
                      "4 numbers", "cell 1 of 2");
    EXPECT_UNREADABLE("a.vtk", small("CELLS 1 5\n3 0 1 2 3\nCELL_TYPES 1\n5\n"), "a.vtk:7",
                      "1 cells", "4 numbers", "5");
    EXPECT_UNREADABLE("a.vtk", small("CELLS 1 4\n3 0 1 2\n"), "a.vtk:7", "0 types", "1 offsets",
                      "3", "3 corners");
    EXPECT_UNREADABLE("a.vtk", small("CELLS 1 2000000000\n3 0 1 2\n"), "a.vtk:7",
                      "2000000000 numbers", "9 bytes", "2 bytes");
    EXPECT_UNREADABLE("a.vtk", start + "ASCII\nDATASET POLYDATA\nPOINTS 1 float\n0 nan 0\n",
                      "a.vtk:5", "vertex 0", "coordinate", "NaN");
    EXPECT_UNREADABLE("a.vtk", start + "ASCII\nDATASET POLYDATA\nPOINTS 1 quad\n0 0 0\n", "a.vtk:5",
                      "quad", "type");
}

TEST(Vtk, RealFilesHaveTheirTags) {
    if (const auto path = test_datum("tet/beam-tet.vtk")) {
        const auto tags = read_mesh(*path).tags;
        EXPECT_EQ(std::count(tags.begin(), tags.end(), 1), 24);
        EXPECT_EQ(std::count(tags.begin(), tags.end(), 2), 24);
    }
}

} // namespace polydec::test::in_vtk
