// SPDX-License-Identifier: MIT
#include "tests/io/support.h"

namespace polydec::test::in_vtu {

std::string attribute(const std::string& tag, const std::string& name) {
    const auto begin = tag.find(" " + name + "=\"") + name.size() + 3;
    return tag.substr(begin, tag.find('"', begin) - begin);
}

std::string decoded(const std::string& base64) {
    const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    EXPECT_EQ(base64.size() % 4, 0U);
    std::string bytes;
    unsigned bits = 0;
    int count = 0;
    for (const char c : base64.substr(0, base64.find('='))) {
        bits = bits << 6 | static_cast<unsigned>(alphabet.find(c));
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes += static_cast<char>(bits >> count & 0xFFU);
        }
    }
    return bytes;
}

template <typename Number>
std::vector<double> numbers(const std::string& bytes) {
    std::vector<double> values;
    for (std::size_t i = 0; i < bytes.size(); i += sizeof(Number)) {
        Number value;
        std::memcpy(&value, bytes.data() + i, sizeof(Number));
        values.push_back(static_cast<double>(value));
    }
    return values;
}

std::vector<double> values_of(const std::string& tag, const std::string& content) {
    const auto bytes = decoded(content);
    std::uint64_t size = 0;
    std::memcpy(&size, bytes.data(), sizeof(size));
    EXPECT_EQ(size, bytes.size() - sizeof(size)) << tag;
    const auto body = bytes.substr(sizeof(size));
    const auto type = attribute(tag, "type");
    if (type == "Float64")
        return numbers<double>(body);
    if (type == "Int64")
        return numbers<std::int64_t>(body);
    return type == "Int32" ? numbers<std::int32_t>(body) : numbers<std::uint8_t>(body);
}

/// All arrays of a file by the tag around them and their name, such as "PointData/u".
std::map<std::string, std::vector<double>> arrays(const std::string& text) {
    std::map<std::string, std::vector<double>> result;
    std::string section;
    for (std::size_t begin = text.find('<'); begin != std::string::npos;
         begin = text.find('<', begin + 1)) {
        const auto end = text.find('>', begin);
        const auto tag = text.substr(begin, end - begin);
        if (tag.substr(0, 10) != "<DataArray") {
            section = tag.substr(1);
            continue;
        }
        const auto content = text.substr(end + 2, text.find('\n', end + 2) - end - 2);
        result[section + "/" + attribute(tag, "Name")] = values_of(tag, content);
        begin = text.find("</DataArray>", end);
    }
    return result;
}

/// One cell of every kind, on the corners of a cube and of a square.
VtuGrid every_kind() {
    VtuGrid grid;
    grid.points = Points{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                         {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    const std::vector<Index> corners{0, 1, 2, 3, 4};
    const std::span<const Index> all = corners;
    add_cell(grid, VtuCell::vertex, all.first(1));
    add_cell(grid, VtuCell::line, all.first(2));
    add_cell(grid, VtuCell::triangle, all.first(3));
    add_cell(grid, VtuCell::quad, all.first(4));
    add_polyhedron(
        grid, {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
    add_cell(grid, VtuCell::tetra, std::vector<Index>{0, 1, 3, 4});
    add_cell(grid, VtuCell::polygon, std::vector<Index>{0, 1, 2, 6, 7});
    return grid;
}

std::string vtu_error(const VtuGrid& grid) {
    return error_of([&grid] { write_vtu("a.vtu", grid); });
}

TEST(Vtu, HoldsCellsOfEveryKind) {
    const TemporaryFolder folder;
    write_vtu(folder.path("a.vtu"), every_kind());
    const auto text = read_text(folder.path("a.vtu"));
    EXPECT_EQ(text.substr(0, text.find("<Points>")),
              "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
              "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n"
              "<Piece NumberOfPoints=\"8\" NumberOfCells=\"7\">\n");

    using Numbers = std::vector<double>;
    auto found = arrays(text);
    EXPECT_EQ(found.at("Points/Points"),
              (Numbers{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1}));
    EXPECT_EQ(found.at("Cells/connectivity"), (Numbers{0, 0, 1, 0, 1, 2, 0, 1, 2, 3, 0, 1, 2, 3,
                                                       4, 5, 6, 7, 0, 1, 3, 4, 0, 1, 2, 6, 7}));
    EXPECT_EQ(found.at("Cells/offsets"), (Numbers{1, 3, 6, 10, 18, 22, 27}));
    EXPECT_EQ(found.at("Cells/types"), (Numbers{1, 3, 5, 9, 42, 10, 7}));
    EXPECT_EQ(found.at("Cells/faceoffsets"), (Numbers{-1, -1, -1, -1, 31, -1, -1}));
    EXPECT_EQ(found.at("Cells/faces"), (Numbers{6, 4, 0, 3, 2, 1, 4, 4, 5, 6, 7, 4, 0, 1, 5, 4,
                                                4, 1, 2, 6, 5, 4, 2, 3, 7, 6, 4, 3, 0, 4, 7}));
}

TEST(Vtu, HoldsPointAndCellData) {
    auto grid = every_kind();
    const Vector u = Vector::LinSpaced(8, 0.1, 1.7);
    grid.point_data.push_back(vtu_array("u <&\">", u));
    grid.point_data.push_back({"vectors", std::vector<double>(24, -1.5), 3});
    grid.cell_data.push_back({"class", std::vector<Index>{1, 2, 3, -4, 5, 6, 7}, 1});
    const TemporaryFolder folder;
    write_vtu(folder.path("a.vtu"), grid);

    const auto text = read_text(folder.path("a.vtu"));
    EXPECT_NE(text.find("<DataArray type=\"Float64\" Name=\"vectors\" NumberOfComponents=\"3\" "
                        "format=\"binary\">"),
              std::string::npos);
    auto found = arrays(text);
    EXPECT_EQ(found.at("PointData/u &lt;&amp;&quot;&gt;"), std::vector<double>(u.begin(), u.end()));
    EXPECT_EQ(found.at("PointData/vectors"), std::vector<double>(24, -1.5));
    EXPECT_EQ(found.at("CellData/class"), (std::vector<double>{1, 2, 3, -4, 5, 6, 7}));
}

TEST(Vtu, PadsPointsAndLeavesOutFacesWithoutPolyhedra) {
    VtuGrid grid;
    grid.points = Points{{3}, {5}};
    add_cell(grid, VtuCell::line, std::vector<Index>{0, 1});
    const TemporaryFolder folder;
    write_vtu(folder.path("a.vtu"), grid);
    auto found = arrays(read_text(folder.path("a.vtu")));
    EXPECT_EQ(found.at("Points/Points"), (std::vector<double>{3, 0, 0, 5, 0, 0}));
    EXPECT_EQ(found.count("Cells/faces"), 0U);
    EXPECT_EQ(found.count("Cells/faceoffsets"), 0U);
}

TEST(Vtu, LargeArraysAreWhole) {
    VtuGrid grid;
    grid.points = Points::Random(100000, 3);
    for (Index i = 0; i < 100000; ++i)
        add_cell(grid, VtuCell::vertex, std::span<const Index>(&i, 1));
    const TemporaryFolder folder;
    write_vtu(folder.path("a.vtu"), grid);
    auto found = arrays(read_text(folder.path("a.vtu")));
    EXPECT_EQ(found.at("Points/Points"),
              std::vector<double>(grid.points.data(), grid.points.data() + grid.points.size()));
    EXPECT_EQ(found.at("Cells/connectivity").back(), 99999);
}

TEST(Vtu, RefusesWhatIsNotFinite) {
    auto grid = every_kind();
    grid.point_data.push_back({"u", std::vector<double>(8, 0.0), 1});
    grid.cell_data.push_back({"v", std::vector<double>(21, 0.0), 3});
    std::get<std::vector<double>>(grid.cell_data[0].values)[7] = std::nan("");
    EXPECT_SAYS(vtu_error(grid), "InvalidInput", "a.vtu", "array", "v", "cells", "NaN", "entry 2");
    std::get<std::vector<double>>(grid.point_data[0].values)[3] = -HUGE_VAL;
    EXPECT_SAYS(vtu_error(grid), "InvalidInput", "a.vtu", "array", "u", "points", "NaN", "entry 3");
    grid.points(5, 1) = HUGE_VAL;
    EXPECT_SAYS(vtu_error(grid), "InvalidInput", "a.vtu", "point 5", "coordinate", "NaN");
}

TEST(Vtu, RefusesArraysThatDoNotFit) {
    auto grid = every_kind();
    grid.point_data.push_back({"u", std::vector<double>(7), 1});
    EXPECT_SAYS(vtu_error(grid), "InvalidInput", "a.vtu", "array", "u", "7 values", "1 components",
                "1", "3", "8 points");
    grid.point_data[0] = {"", std::vector<double>(8), 1};
    EXPECT_SAYS(vtu_error(grid), "InvalidInput", "a.vtu", "name ''", "points", "empty");
    grid.point_data[0] = {"u", std::vector<double>(8), 1};
    grid.point_data.push_back(grid.point_data[0]);
    EXPECT_SAYS(vtu_error(grid), "InvalidInput", "a.vtu", "name 'u'", "points", "not unique");
}

TEST(Vtu, RefusesCellsThatDoNotFit) {
    auto grid = every_kind();
    grid.points.conservativeResize(7, 3);
    EXPECT_SAYS(vtu_error(grid), "InvalidInput", "a.vtu", "cell 4", "point 7", "0", "6");
    grid = every_kind();
    grid.types[3] = VtuCell::triangle;
    EXPECT_SAYS(vtu_error(grid), "InvalidInput", "a.vtu", "cell 3", "type 5", "4 corners");
    grid = every_kind();
    grid.faces[1] = 5;
    EXPECT_SAYS(vtu_error(grid), "InvalidInput", "a.vtu", "faces", "polyhedron 4");
    grid = every_kind();
    grid.types[4] = VtuCell::polygon;
    EXPECT_SAYS(vtu_error(grid), "InvalidInput", "a.vtu", "cell 4", "polyhedra", "faces");
    grid = every_kind();
    grid.offsets.pop_back();
    EXPECT_SAYS(vtu_error(grid), "InvalidInput", "a.vtu", "types", "offsets", "corners");
    grid = every_kind();
    grid.points = Points::Zero(8, 4);
    EXPECT_SAYS(vtu_error(grid), "InvalidInput", "a.vtu", "points", "R^3", "R^4");
}

} // namespace polydec::test::in_vtu
