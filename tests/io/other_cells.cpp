// SPDX-License-Identifier: MIT
#include "tests/io/support.h"

namespace polydec::test::in_other_cells {

using Cells = std::vector<std::vector<Index>>;

struct Solid {
    const char* name;
    int vtk, gmsh;
    const char* medit;
    std::vector<Index> corners; ///< of the unit cube, whose vertices are numbered along x, y, z
    double volume;
};

const std::vector<Solid> solids{
    {"hexahedron", 12, 5, "Hexahedra", {0, 1, 3, 2, 4, 5, 7, 6}, 1.0},
    {"wedge", 13, 6, "Prisms", {0, 1, 2, 4, 5, 6}, 0.5},
    {"pyramid", 14, 7, "Pyramids", {0, 1, 3, 2, 4}, 1.0 / 3},
    {"tetrahedron", 10, 4, "Tetrahedra", {0, 1, 2, 4}, 1.0 / 6},
    {"voxel", 11, 0, "", {0, 1, 2, 3, 4, 5, 6, 7}, 1.0},
};

std::string points(bool numbered, const char* behind, int count = 8) {
    std::string text;
    for (int v = 0; v < count; ++v)
        text += (numbered ? std::to_string(v + 1) + " " : "") + std::to_string(v & 1) + " " +
                std::to_string(v >> 1 & 1) + " " + std::to_string(v >> 2 & 1) + behind + "\n";
    return text;
}

std::string list(const std::vector<Index>& corners, Index first) {
    std::string text;
    for (const Index corner : corners)
        text += std::to_string(corner + first) + " ";
    return text;
}

std::string vtk(int type, const std::vector<Index>& corners) {
    const auto count = std::to_string(corners.size());
    return "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 8 float\n" +
           points(false, "") + "CELLS 1 " + std::to_string(corners.size() + 1) + "\n" + count +
           " " + list(corners, 0) + "\nCELL_TYPES 1\n" + std::to_string(type) + "\n";
}

std::string gmsh(int type, const std::vector<Index>& corners) {
    return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n8\n" + points(true, "") +
           "$EndNodes\n$Elements\n1\n1 " + std::to_string(type) + " 2 7 1 " + list(corners, 1) +
           "\n$EndElements\n";
}

std::string medit(const std::string& section, const std::vector<Index>& corners) {
    return "MeshVersionFormatted 2\nDimension 3\nVertices 8\n" + points(false, " 0") + section +
           " 1\n" + list(corners, 1) + "7\nEnd\n";
}

/// The corners and so many numbers of vertices that are none.
std::vector<Index> with_nodes(std::vector<Index> corners, std::size_t nodes) {
    for (std::size_t i = corners.size(); i < nodes; ++i)
        corners.push_back(7);
    return corners;
}

bool tells_of_higher_order(const Mesh& mesh) {
    return std::any_of(mesh.warnings.begin(), mesh.warnings.end(), [](const auto& warning) {
        return warning.find("1 cell of second or higher order") != std::string::npos;
    });
}

TEST(OtherCells, EveryFormatHasTheSameSolids) {
    for (const auto& solid : solids) {
        const Mesh mesh = read_from("a.vtk", vtk(solid.vtk, solid.corners));
        EXPECT_EQ(mesh.dimension(), 3) << solid.name;
        EXPECT_NEAR(total_volume(mesh), solid.volume, 1e-14) << solid.name;
        EXPECT_EQ(mesh.points.rows(), 8);
        if (solid.gmsh == 0)
            continue;
        const Mesh other = read_from("a.msh", gmsh(solid.gmsh, solid.corners));
        EXPECT_TRUE(same(mesh, other)) << solid.name;
        EXPECT_EQ(other.tags,
                  std::vector<Index>(static_cast<std::size_t>(mesh.simplices.rows()), 7));
        const Mesh third = read_from("a.mesh", medit(solid.medit, solid.corners));
        EXPECT_TRUE(same(mesh, third)) << solid.name;
        EXPECT_EQ(third.tags, other.tags);
        EXPECT_EQ(third.warnings, mesh.warnings);
    }
}

TEST(OtherCells, AVoxelIsTheHexahedronAlongTheAxes) {
    EXPECT_TRUE(same(read_from("a.vtk", vtk(11, solids[4].corners)),
                     read_from("a.vtk", vtk(12, solids[0].corners))));
}

TEST(OtherCells, PrismsOfMoreSidesAreSolidsOfVtk) {
    // The base is a square with a corner in the middle of one or two sides.
    for (const int type : {15, 16}) {
        const int base = type == 15 ? 5 : 6;
        std::string places, corners;
        const std::array<std::array<double, 2>, 6> ring{
            {{0, 0}, {1, 0}, {1, 1}, {0.5, 1.5}, {0, 1}, {-0.5, 0.5}}};
        double area = 0;
        for (int i = 0; i < base; ++i) {
            const auto& [x, y] = ring[static_cast<std::size_t>(i)];
            const auto& [u, v] = ring[static_cast<std::size_t>((i + 1) % base)];
            area += (x * v - u * y) / 2;
        }
        for (int i = 0; i < 2 * base; ++i) {
            const auto& [x, y] = ring[static_cast<std::size_t>(i % base)];
            places += std::to_string(x) + " " + std::to_string(y) + (i < base ? " 0\n" : " 2\n");
            corners += " " + std::to_string(i);
        }
        const auto count = std::to_string(2 * base);
        const Mesh mesh = read_from(
            "a.vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " +
                         count + " float\n" + places + "CELLS 1 " + std::to_string(2 * base + 1) +
                         "\n" + count + corners + "\nCELL_TYPES 1\n" + std::to_string(type) + "\n");
        EXPECT_NEAR(total_volume(mesh), 2 * area, 1e-14);
    }
}

TEST(OtherCells, CellsOfHigherOrderAreReadByTheirCorners) {
    struct Kind {
        int vtk, gmsh;
        const char* medit;
        std::vector<Index> corners;
        std::size_t nodes;
    };
    const std::vector<Index> hexahedron = solids[0].corners, wedge = solids[1].corners,
                             pyramid = solids[2].corners, tetrahedron = solids[3].corners,
                             quad{0, 1, 3, 2}, triangle{0, 1, 2}, line{0, 1};
    for (const auto& kind : std::vector<Kind>{{21, 8, "EdgesP2", line, 3},
                                              {22, 9, "TrianglesP2", triangle, 6},
                                              {34, 0, "", triangle, 7},
                                              {69, 21, "", triangle, 10},
                                              {23, 16, "", quad, 8},
                                              {28, 10, "QuadrilateralsQ2", quad, 9},
                                              {36, 0, "", quad, 8},
                                              {24, 11, "TetrahedraP2", tetrahedron, 10},
                                              {71, 29, "", tetrahedron, 20},
                                              {25, 17, "", hexahedron, 20},
                                              {29, 12, "HexahedraQ2", hexahedron, 27},
                                              {72, 92, "", hexahedron, 64},
                                              {26, 18, "", wedge, 15},
                                              {32, 13, "PrismsP2", wedge, 18},
                                              {27, 19, "", pyramid, 13},
                                              {0, 14, "PyramidsP2", pyramid, 14}}) {
        const auto dimension = kind.corners.size() == 2                           ? 1
                               : kind.corners == quad || kind.corners.size() == 3 ? 2
                                                                                  : 3;
        const int linear_type = dimension == 1                ? 3
                                : kind.corners.size() == 3    ? 5
                                : kind.corners == quad        ? 9
                                : kind.corners == tetrahedron ? 10
                                : kind.corners == hexahedron  ? 12
                                : kind.corners == wedge       ? 13
                                                              : 14;
        const Mesh linear = read_from("a.vtk", vtk(linear_type, kind.corners));
        const auto all = with_nodes(kind.corners, kind.nodes);
        if (kind.vtk > 0) {
            const Mesh mesh = read_from("a.vtk", vtk(kind.vtk, all));
            EXPECT_TRUE(same(mesh, linear)) << kind.vtk;
            EXPECT_TRUE(tells_of_higher_order(mesh)) << kind.vtk;
        }
        if (kind.gmsh > 0) {
            const Mesh mesh = read_from("a.msh", gmsh(kind.gmsh, all));
            EXPECT_TRUE(same(mesh, linear)) << kind.gmsh;
            EXPECT_TRUE(tells_of_higher_order(mesh)) << kind.gmsh;
        }
        if (*kind.medit != '\0') {
            const Mesh mesh = read_from("a.mesh", medit(kind.medit, all));
            EXPECT_TRUE(same(mesh, linear)) << kind.medit;
            EXPECT_TRUE(tells_of_higher_order(mesh)) << kind.medit;
        }
        EXPECT_FALSE(tells_of_higher_order(linear));
    }
}

TEST(OtherCells, QuadsOfAGroupOnTheSurfaceOfASolidAreItsFacets) {
    const std::string text =
        medit("Hexahedra", solids[0].corners) + "Quadrilaterals 1\n1 2 4 3 5\nEnd\n";
    std::string joined = text;
    joined.erase(joined.find("End\n"), 4);
    const Mesh mesh = read_from("a.mesh", joined);
    EXPECT_EQ(mesh.facet_tags.tags, (std::vector<Index>{5, 5}));
    EXPECT_EQ(rows(mesh.facet_tags.simplices), (Cells{{0, 1, 3}, {0, 3, 2}}));
}

TEST(OtherCells, CellsBesideThoseOfTheMeshAreTold) {
    const std::string start = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                              "POINTS 8 float\n" +
                              points(false, "");
    const Mesh mesh = read_from("a.vtk", start + "CELLS 3 13\n4 0 1 2 4\n3 0 1 2\n3 3 5 7\n"
                                                 "CELL_TYPES 3\n10 5 5\n");
    EXPECT_EQ(mesh.simplices.rows(), 1);
    EXPECT_EACH_SAYS(mesh.warnings, {"1 triangle", "dimension 3", "3, 5, 7"});
    const Mesh planar = read_from("a.vtk", start + "CELLS 3 11\n4 0 1 3 2\n2 0 1\n2 5 7\n"
                                                   "CELL_TYPES 3\n9 3 3\n");
    EXPECT_EACH_SAYS(planar.warnings, {"1 edge", "dimension 2", "5, 7"},
                     {"1 polygon", "triangles"});
    const std::string places = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n5 5 5\n6 5 5\n";
    const Mesh medit =
        read_from("a.mesh", "Dimension 3\nVertices 6\n" + with_line_breaks(places, " 0\n") +
                                "Edges 2\n5 6 3\n1 2 0\nTetrahedra 1\n1 2 3 4 0\n");
    EXPECT_EACH_SAYS(medit.warnings, {"1 edge", "dimension 3", "4, 5"});
    const Mesh ply =
        read_from("a.ply", "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\n"
                           "property float y\nproperty float z\nelement edge 2\n"
                           "property int vertex1\nproperty int vertex2\nelement face 1\n"
                           "property list uchar int vertex_indices\nend_header\n" +
                               places + "0 1\n4 5\n3 0 1 2\n");
    EXPECT_EACH_SAYS(ply.warnings, {"1 edge", "dimension 2", "4, 5"});
}

TEST(OtherCells, StructuredGridsOfVtkAreGridsOfVoxels) {
    const std::string start = "# vtk DataFile Version 3.0\nx\n";
    const std::string tags = "CELL_DATA 2\nSCALARS material int\nLOOKUP_TABLE default\n4 5\n";
    const auto image = read_from("a.vtk", start +
                                              "ASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 3 2 2\n"
                                              "ORIGIN 1 2 3\nSPACING 0.5 2 4\n" +
                                              tags);
    const auto rectilinear =
        read_from("a.vtk", start +
                               "ASCII\nDATASET RECTILINEAR_GRID\nDIMENSIONS 3 2 2\n"
                               "X_COORDINATES 3 float 1 1.5 2\nY_COORDINATES 2 float\n2 4\n"
                               "Z_COORDINATES 2 double\n3 7\n" +
                               tags);
    std::string places;
    for (int v = 0; v < 12; ++v)
        places += std::to_string(1 + 0.5 * (v % 3)) + " " + std::to_string(2 + 2 * (v / 3 % 2)) +
                  " " + std::to_string(3 + 4 * (v / 6)) + "\n";
    const auto structured =
        read_from("a.vtk", start +
                               "ASCII\nDATASET STRUCTURED_GRID\nDIMENSIONS 3 2 2\n"
                               "POINTS 12 float\n" +
                               places + tags);
    EXPECT_NEAR(total_volume(image), 8.0, 1e-12);
    EXPECT_EQ(image.simplices.rows(), 12);
    EXPECT_EQ(image.tags, (std::vector<Index>{4, 4, 4, 4, 4, 4, 5, 5, 5, 5, 5, 5}));
    EXPECT_TRUE(same(image, rectilinear));
    EXPECT_TRUE(same(image, structured));
    EXPECT_EQ(image.tags, structured.tags);
}

TEST(OtherCells, StructuredGridsMayHaveFewerAxes) {
    const auto grid = [](const std::string& dimensions) {
        return read_from("a.vtk",
                         "# vtk DataFile Version 2.0\nx\nASCII\nDATASET STRUCTURED_POINTS\n"
                         "DIMENSIONS " +
                             dimensions + "\nORIGIN 0 0 0\nASPECT_RATIO 1 1 1\n");
    };
    for (const char* dimensions : {"3 4 1", "1 3 4", "3 1 4"}) {
        EXPECT_EQ(grid(dimensions).dimension(), 2);
        EXPECT_NEAR(total_volume(grid(dimensions)), 6.0, 1e-12);
    }
    EXPECT_EQ(rows(grid("1 1 4").simplices), (Cells{{0, 1}, {1, 2}, {2, 3}}));
    const auto text = [](const std::string& rest) {
        return "# vtk DataFile Version 2.0\nx\nASCII\nDATASET " + rest;
    };
    EXPECT_UNREADABLE("a.vtk", text("STRUCTURED_POINTS\nDIMENSIONS 1 1 1\n"), "a.vtk:5",
                      "one point");
    EXPECT_UNREADABLE("a.vtk", text("STRUCTURED_POINTS\nDIMENSIONS 2000 2000 2000\n"), "a.vtk:5",
                      "2000 x 2000 x 2000", "2^31");
    EXPECT_UNREADABLE("a.vtk", text("STRUCTURED_GRID\nDIMENSIONS 2 2 1\nPOINTS 1 float\n0 0 0\n"),
                      "a.vtk:5", "1 points", "2 x 2 x 1");
    EXPECT_UNREADABLE("a.vtk",
                      text("RECTILINEAR_GRID\nDIMENSIONS 2 2 1\nX_COORDINATES 3 float\n0 1 2\n"),
                      "a.vtk:5", "3 coordinates", "axis 0", "2 points");
}

} // namespace polydec::test::in_other_cells
