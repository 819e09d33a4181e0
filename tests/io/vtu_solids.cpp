// SPDX-License-Identifier: MIT
#include "io/pictures/vtu_solids.h"

#include "tests/io/support.h"

namespace polydec::test::in_vtu_solids {

using FaceLists = std::vector<std::vector<Index>>;

const FaceLists tetra{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
const FaceLists cube{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                     {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
const FaceLists pyramid{{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};

/// Faces as cycles that begin with their smallest corner: the same if and only if turned the same.
std::set<std::vector<Index>> cycles(FaceLists faces) {
    std::set<std::vector<Index>> result;
    for (auto& face : faces) {
        std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
        result.insert(face);
    }
    return result;
}

/// The faces that VTK gives a cell with these corners.
template <typename Table>
FaceLists faces_by(const Table& table, const std::vector<Index>& corners) {
    FaceLists faces;
    for (const auto& face : table) {
        faces.emplace_back();
        for (const int corner : face)
            faces.back().push_back(corners[static_cast<std::size_t>(corner)]);
    }
    return faces;
}

/// Every order of the faces, each begun at every one of its corners in turn.
void expect_type(FaceLists faces, VtuCell type) {
    const auto wanted = cycles(faces);
    std::sort(faces.begin(), faces.end());
    int turn = 0;
    do {
        auto turned = faces;
        for (auto& face : turned)
            std::rotate(face.begin(), face.begin() + ++turn % std::ssize(face), face.end());
        VtuGrid grid;
        ASSERT_TRUE(add_simple_solid(grid, turned));
        EXPECT_EQ(grid.types, std::vector{type});
        EXPECT_EQ(cycles(type == VtuCell::tetra ? faces_by(tetra_faces, grid.corners)
                                                : faces_by(hexahedron_faces, grid.corners)),
                  wanted);
    } while (std::next_permutation(faces.begin(), faces.end()));
}

bool is_simple(const FaceLists& faces) {
    VtuGrid grid;
    const bool result = add_simple_solid(grid, faces);
    EXPECT_EQ(grid.types.empty(), !result);
    return result;
}

TEST(VtuSolids, TetrahedraAndHexahedraAreFoundInAnyOrderAndTurnedAsTheirFaces) {
    expect_type(tetra, VtuCell::tetra);
    expect_type(cube, VtuCell::hexahedron);
}

TEST(VtuSolids, OthersAreNone) {
    // the twin: as many faces of as many corners, but another cell
    EXPECT_FALSE(is_simple(pyramid));
    EXPECT_FALSE(is_simple({}));
    auto other = cube;
    other[5] = {3, 0, 4, 8};
    EXPECT_FALSE(is_simple(other));
    other = cube;
    other[5] = other[4];
    EXPECT_FALSE(is_simple(other));
    other = tetra;
    other[3] = {0, 4, 2};
    EXPECT_FALSE(is_simple(other));
    other = tetra;
    other[3] = {0, 3, 2, 1};
    EXPECT_FALSE(is_simple(other));
}

TEST(VtuSolids, PolygonsHaveTheTypeOfTheirNumberOfCorners) {
    VtuGrid grid;
    const std::vector<Index> corners{0, 1, 2, 3, 4};
    for (const std::size_t size : {3, 4, 5})
        add_polygon(grid, std::span(corners).first(size));
    EXPECT_EQ(grid.types, (std::vector{VtuCell::triangle, VtuCell::quad, VtuCell::polygon}));
}

TEST(VtuSolids, FacesOfPolyhedraFitTogether) {
    const std::vector<Index> list{9, 2, 3, 0, 1, 2, 4, 3, 4, 5, 6};
    const auto faces = polyhedron_faces(list, 1, 11);
    ASSERT_TRUE(faces);
    ASSERT_EQ(faces->size(), 2);
    EXPECT_TRUE(std::ranges::equal((*faces)[0], std::vector{0, 1, 2}));
    EXPECT_TRUE(std::ranges::equal((*faces)[1], std::vector{3, 4, 5, 6}));
    // another number of faces, too few corners, the end of the list, nothing, and before the list
    EXPECT_FALSE(polyhedron_faces(std::vector<Index>{1, 3, 0, 1, 2, 3, 3, 4, 5}, 0, 9));
    EXPECT_FALSE(polyhedron_faces(std::vector<Index>{1, 2, 0, 1}, 0, 4));
    EXPECT_FALSE(polyhedron_faces(list, 1, 10));
    EXPECT_FALSE(polyhedron_faces(list, 1, 12));
    EXPECT_FALSE(polyhedron_faces(list, 1, 1));
    EXPECT_FALSE(polyhedron_faces(list, -1, 3));
}

TEST(VtuSolids, WhatIsWrittenIsReadAsItIs) {
    VtuGrid grid;
    grid.points = Points::Random(8, 3);
    ASSERT_TRUE(add_simple_solid(grid, cube));
    ASSERT_TRUE(add_simple_solid(grid, tetra));
    const TemporaryFolder folder;
    write_vtu(folder.path("a.vtu"), grid);
    const auto found = read_grid(folder.path("a.vtu"));
    EXPECT_TRUE(same(found, grid));
    EXPECT_EQ(found.points, grid.points);
    EXPECT_EQ(read_text(folder.path("a.vtu")).find("faces"), std::string::npos);
}

} // namespace polydec::test::in_vtu_solids
