// SPDX-License-Identifier: MIT
#include "tests/io/support.h"

namespace polydec::test::in_vtu {

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
    return refusal([&grid] { write_vtu("a.vtu", grid); });
}

TEST(Vtu, HoldsCellsOfEveryKind) {
    const TemporaryFolder folder;
    const auto grid = every_kind();
    write_vtu(folder.path("a.vtu"), grid);
    const auto text = read_text(folder.path("a.vtu"));
    EXPECT_EQ(text.substr(0, text.find("<Points>")),
              "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
              "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n"
              "<Piece NumberOfPoints=\"8\" NumberOfCells=\"7\">\n");
    const auto found = read_grid(folder.path("a.vtu"));
    EXPECT_TRUE(same(found, grid));
    EXPECT_EQ(found.points, grid.points);
    EXPECT_EQ(found.face_offsets, (std::vector<std::int64_t>{-1, -1, -1, -1, 31, -1, -1}));
    EXPECT_EQ(found.faces, (std::vector<Index>{6, 4, 0, 3, 2, 1, 4, 4, 5, 6, 7, 4, 0, 1, 5, 4,
                                               4, 1, 2, 6, 5, 4, 2, 3, 7, 6, 4, 3, 0, 4, 7}));
}

TEST(Vtu, HoldsPointAndCellData) {
    auto grid = every_kind();
    grid.point_data.push_back(vtu_array("u <&\">", Vector::LinSpaced(8, 0.1, 1.7)));
    grid.point_data.push_back({"vectors", std::vector<double>(24, -1.5), 3});
    grid.cell_data.push_back({"class", std::vector<Index>{1, 2, 3, -4, 5, 6, 7}, 1});
    const TemporaryFolder folder;
    write_vtu(folder.path("a.vtu"), grid);

    const auto text = read_text(folder.path("a.vtu"));
    for (const char* tag : {"<DataArray type=\"Float64\" Name=\"vectors\" NumberOfComponents=\"3\" "
                            "format=\"binary\">",
                            "Name=\"u &lt;&amp;&quot;&gt;\""})
        EXPECT_NE(text.find(tag), std::string::npos) << tag;
    const auto found = read_grid(folder.path("a.vtu"));
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(found.point_data.at(i).name, grid.point_data[i].name);
        EXPECT_EQ(found.point_data[i].values, grid.point_data[i].values);
    }
    EXPECT_EQ(std::get<std::vector<double>>(found.cell_data.at(0).values),
              (std::vector<double>{1, 2, 3, -4, 5, 6, 7}));
}

TEST(Vtu, PadsPointsAndLeavesOutFacesWithoutPolyhedra) {
    VtuGrid grid;
    grid.points = Points{{3}, {5}};
    add_cell(grid, VtuCell::line, std::vector<Index>{0, 1});
    const TemporaryFolder folder;
    write_vtu(folder.path("a.vtu"), grid);
    EXPECT_EQ(read_grid(folder.path("a.vtu")).points, (Points{{3, 0, 0}, {5, 0, 0}}));
    EXPECT_EQ(read_text(folder.path("a.vtu")).find("face"), std::string::npos);
}

TEST(Vtu, LargeArraysAreWhole) {
    VtuGrid grid;
    grid.points = Points::Random(100000, 3);
    for (Index i = 0; i < 100000; ++i)
        add_cell(grid, VtuCell::vertex, std::span<const Index>(&i, 1));
    const TemporaryFolder folder;
    write_vtu(folder.path("a.vtu"), grid);
    const auto found = read_grid(folder.path("a.vtu"));
    EXPECT_EQ(found.points, grid.points);
    EXPECT_TRUE(same(found, grid));
}

TEST(Vtu, RefusesWhatIsNotFinite) {
    auto grid = every_kind();
    grid.point_data.push_back({"u", std::vector<double>(8, 0.0), 1});
    grid.cell_data.push_back({"v", std::vector<double>(21, 0.0), 3});
    std::get<std::vector<double>>(grid.cell_data[0].values)[7] = std::nan("");
    EXPECT_SAYS(vtu_error(grid), "a.vtu", "array", "v", "cells", "NaN", "entry 2");
    std::get<std::vector<double>>(grid.point_data[0].values)[3] = -HUGE_VAL;
    EXPECT_SAYS(vtu_error(grid), "a.vtu", "array", "u", "points", "NaN", "entry 3");
    grid.points(5, 1) = HUGE_VAL;
    EXPECT_SAYS(vtu_error(grid), "a.vtu", "point 5", "coordinate", "NaN");
}

TEST(Vtu, RefusesArraysThatDoNotFit) {
    auto grid = every_kind();
    grid.point_data.push_back({"u", std::vector<double>(7), 1});
    EXPECT_SAYS(vtu_error(grid), "a.vtu", "array", "u", "7 values", "1 components", "1", "3",
                "8 points");
    grid.point_data[0] = {"", std::vector<double>(8), 1};
    EXPECT_SAYS(vtu_error(grid), "a.vtu", "name ''", "points", "empty");
    grid.point_data[0] = {"u", std::vector<double>(8), 1};
    grid.point_data.push_back(grid.point_data[0]);
    EXPECT_SAYS(vtu_error(grid), "a.vtu", "name 'u'", "points", "not unique");
}

TEST(Vtu, RefusesCellsThatDoNotFit) {
    auto grid = every_kind();
    grid.points.conservativeResize(7, 3);
    EXPECT_SAYS(vtu_error(grid), "a.vtu", "cell 4", "point 7", "0", "6");
    grid = every_kind();
    grid.types[3] = VtuCell::triangle;
    EXPECT_SAYS(vtu_error(grid), "a.vtu", "cell 3", "type 5", "4 corners");
    grid = every_kind();
    grid.faces[1] = 5;
    EXPECT_SAYS(vtu_error(grid), "a.vtu", "faces", "polyhedron 4");
    grid = every_kind();
    grid.types[4] = VtuCell::polygon;
    EXPECT_SAYS(vtu_error(grid), "a.vtu", "cell 4", "polyhedra", "faces");
    grid = every_kind();
    grid.offsets.pop_back();
    EXPECT_SAYS(vtu_error(grid), "a.vtu", "types", "offsets", "corners");
    grid = every_kind();
    grid.points = Points::Zero(8, 4);
    EXPECT_SAYS(vtu_error(grid), "a.vtu", "points", "R^3", "R^4");
}

} // namespace polydec::test::in_vtu
