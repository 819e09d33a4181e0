// SPDX-License-Identifier: MIT
#include "tests/io/bytes.h"
#include "tests/io/support.h"

namespace polydec::test::in_odd_files {

using Cells = std::vector<std::vector<Index>>;
using Places = std::vector<std::vector<double>>;

const Cells two_triangles{{0, 1, 2}, {0, 2, 3}};

/// A binary PLY of a unit square, whose header lines end in one way and the last in another.
std::string ply(const std::string& line_break, const std::string& last) {
    const std::string header =
        with_line_breaks("ply\nformat binary_little_endian 1.0\nelement vertex 4\n"
                         "property float x\nproperty float y\nproperty float z\n"
                         "element face 2\nproperty list uchar int vertex_indices\n",
                         line_break);
    std::string body = bytes_of_all<float>(std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0},
                                           std::endian::little);
    for (const auto& triangle : two_triangles)
        body += "\3" + bytes_of_all<std::int32_t>(triangle, std::endian::little);
    return header + "end_header" + last + body;
}

const std::string nodes = "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n";
const std::string elements = "$Elements\n2\n1 2 2 1 1 1 2 3\n2 2 2 1 1 1 3 4\n$EndElements\n";

std::string msh(const std::string& version) {
    return "$MeshFormat\n" + version + " 0 8\n$EndMeshFormat\n" + nodes + elements;
}

/// A triangle in MSH 4.0, with an entity in a group, and a parameter of each node.
std::string msh_4_0(bool is_binary, std::endian order) {
    std::string text = "$MeshFormat\n4 " + std::string(is_binary ? "1" : "0") + " 8\n";
    const auto integers = [&](const std::vector<std::int32_t>& values) {
        for (const auto value : values)
            text += is_binary ? bytes_of(value, order) : std::to_string(value) + " ";
    };
    const auto sizes = [&](const std::vector<std::int64_t>& values) {
        for (const auto value : values)
            text += is_binary ? bytes_of(value, order) : std::to_string(value) + " ";
    };
    const auto reals = [&](const std::vector<double>& values) {
        for (const auto value : values)
            text += is_binary ? bytes_of(value, order) : std::to_string(value) + " ";
    };
    text += (is_binary ? bytes_of(std::int32_t{1}, order) + "\n" : "") + "$EndMeshFormat\n";
    text += "$Entities\n";
    sizes({1, 0, 1, 0});
    integers({6});
    reals({0, 0, 0, 0, 0, 0});
    sizes({0});
    integers({8});
    reals({0, 0, 0, 1, 1, 0});
    sizes({1});
    integers({77});
    sizes({0});
    text += "\n$EndEntities\n$Nodes\n";
    sizes({1, 3});
    integers({8, 2, 1});
    sizes({3});
    for (const auto& [number, x, y] :
         std::vector<std::array<int, 3>>{{7, 0, 0}, {9, 1, 0}, {4, 0, 1}}) {
        integers({number});
        reals({double(x), double(y), 0, 0.5, 0.25});
    }
    text += "\n$EndNodes\n$Elements\n";
    sizes({1, 1});
    integers({8, 2, 2});
    sizes({1});
    integers({1, 7, 9, 4});
    return text + "\n$EndElements\n";
}

std::string stl_text(const std::string& normal) {
    return "solid s\nfacet" + normal +
           "\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
           "endloop\nendfacet\nendsolid\n";
}

std::string stl_binary(std::uint32_t promised, const std::string& behind) {
    std::string text(80, ' ');
    text += bytes_of(promised, std::endian::little);
    text += bytes_of_all<float>(std::vector<double>{0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0},
                                std::endian::little) +
            std::string(2, '\0');
    return text + behind;
}

TEST(OddFiles, TheLastLineOfAHeaderOfPlyMayEndInAnotherWay) {
    const Mesh mesh = read_from("a.ply", ply("\n", "\n"));
    EXPECT_EQ(rows(mesh.simplices), two_triangles);
    EXPECT_TRUE(same(mesh, read_from("a.ply", ply("\n", "\r\n"))));
    EXPECT_TRUE(same(mesh, read_from("a.ply", ply("\r\n", "\n"))));
    EXPECT_TRUE(same(mesh, read_from("a.ply", ply("\r\n", "\r\n"))));
    EXPECT_TRUE(same(mesh, read_from("a.ply", ply("\r", "\r"))));
}

TEST(OddFiles, VersionsOfGmshAreNumbers) {
    const Mesh mesh = read_from("a.msh", msh("2.2"));
    EXPECT_EQ(rows(mesh.simplices), two_triangles);
    for (const char* version : {"2", "2.0", "2.1", "2.200000", "2.20", "2.1000e0"})
        EXPECT_TRUE(same(mesh, read_from("a.msh", msh(version)))) << version;
}

TEST(OddFiles, TheFirstVersionOfGmshHasNoFormat) {
    const std::string text = "$NOD\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$ENDNOD\n"
                             "$ELM\n3\n9 1 5 1 2 1 2\n1 2 3 1 3 1 2 3\n2 2 4 1 3 1 3 4\n$ENDELM\n";
    const Mesh mesh = read_from("a.msh", text);
    EXPECT_EQ(rows(mesh.simplices), two_triangles);
    EXPECT_EQ(mesh.tags, (std::vector<Index>{3, 4}));
    EXPECT_EQ(mesh.facet_tags.tags, (std::vector<Index>{5}));
    EXPECT_TRUE(same(mesh, read_from("a.msh", with_line_breaks(text, "\r\n"))));
    EXPECT_UNREADABLE("a.msh",
                      "$NOD\n1\n1 0 0 0\n$ENDNOD\n$ELM\n1\n1 2 1 1 4 1 1 1 1\n"
                      "$ENDELM\n",
                      "a.msh:7", "type 2", "4 nodes", "3");
}

TEST(OddFiles, VersionFourOfGmshIsReadInEveryEncoding) {
    for (const bool is_binary : {false, true})
        for (const auto order : {std::endian::little, std::endian::big}) {
            const Mesh mesh = read_from("a.msh", msh_4_0(is_binary, order));
            EXPECT_EQ(rows(mesh.points), (Places{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
            EXPECT_EQ(rows(mesh.simplices), (Cells{{0, 1, 2}}));
            EXPECT_EQ(mesh.tags, (std::vector<Index>{77}));
        }
}

TEST(OddFiles, WordsBehindAPhysicalNameArePassedOver) {
    const std::string names = "$PhysicalNames\n2\n1 7 \"left side\" lower_dimensional_block\n"
                              "2 1 \"plate\"\n$EndPhysicalNames\n";
    const auto mesh =
        read_from("a.msh", "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + names + nodes + elements);
    ASSERT_EQ(mesh.groups.size(), 2U);
    EXPECT_EQ(mesh.groups[0].name, "left side");
    EXPECT_EQ(mesh.groups[1].name, "plate");
    EXPECT_EQ(mesh.groups[1].tag, 1);
}

TEST(OddFiles, NumbersOfLegacyVtkMayFollowOnTheLine) {
    const std::string start = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\n";
    const auto mesh = read_from(
        "a.vtk", start + "POINTS 4 float 0 0 0 1 0 0 1 1 0 0 1 0\nPOLYGONS 2 8 3 0 1 2 3 0 2 3 "
                         "CELL_DATA 2 SCALARS material int LOOKUP_TABLE default 4 5\n");
    EXPECT_EQ(rows(mesh.simplices), two_triangles);
    EXPECT_EQ(mesh.tags, (std::vector<Index>{4, 5}));
    EXPECT_EQ(rows(read_from("a.vtk", start + "POINTS 3 float\n0 0 0 1 0\n0 2 0 0\n"
                                              "LINES 1 4 3\n0\n1\n2\n")
                       .simplices),
              (Cells{{0, 1}, {1, 2}}));
}

TEST(OddFiles, StringsBitsAndMetadataOfLegacyVtkArePassedOver) {
    const std::string start = "# vtk DataFile Version 4.2\nx\nASCII\nDATASET POLYDATA\n";
    const std::string field =
        "FIELD FieldData 3\nnames 1 2 string\na%20b\nc d\nflags 1 3 bit\n1 0 1\n"
        "METADATA\nINFORMATION 1\nNAME a LOCATION b\nDATA 0\n\nTIME 1 1 "
        "double\n0.5\n";
    const std::string grid =
        "POINTS 3 vtktypefloat64\n0 0 0 1 0 0 0 1 0\nMETADATA\nINFORMATION 0\n\n"
        "POLYGONS 1 4\n3 0 1 2\n";
    EXPECT_EQ(rows(read_from("a.vtk", start + field + grid).simplices), (Cells{{0, 1, 2}}));

    std::string binary = "# vtk DataFile Version 4.2\nx\nBINARY\nDATASET POLYDATA\n";
    binary += "FIELD FieldData 2\nnames 1 3 string\n";
    binary += std::string("\xC2", 1) + "ab";
    binary += std::string("\x80\x46", 2) + std::string(70, 'x');
    binary += std::string("\x40\0\0\1", 4) + "y\n";
    binary += "flags 1 9 bit\n" + std::string("\xA0\x80", 2) + "\nPOINTS 3 float\n";
    binary += bytes_of_all<float>(std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0}, std::endian::big);
    binary += "\nPOLYGONS 1 4\n" +
              bytes_of_all<std::int32_t>(std::vector<double>{3, 0, 1, 2}, std::endian::big) + "\n";
    EXPECT_EQ(rows(read_from("a.vtk", binary).simplices), (Cells{{0, 1, 2}}));
}

TEST(OddFiles, BytesBehindTheTrianglesOfAnStlAreLeftOut) {
    const Mesh mesh = read_from("a.stl", stl_binary(1, std::string(17, 'x')));
    EXPECT_EQ(mesh.simplices.rows(), 1);
    EXPECT_EACH_SAYS(mesh.warnings, {"17 bytes", "1 triangles"});
    EXPECT_TRUE(read_from("a.stl", stl_binary(1, "")).warnings.empty());
    EXPECT_UNREADABLE("a.stl", stl_binary(2, "x"), "a.stl", "135 bytes", "184", "2 triangles",
                      "cut off");
}

TEST(OddFiles, FacetsOfAnStlMayHaveNoNormal) {
    const Mesh mesh = read_from("a.stl", stl_text(" normal 0 0 1"));
    for (const char* normal : {"", " normal", " normal nan nan nan", " Normal\n0 0\n1"})
        EXPECT_TRUE(same(mesh, read_from("a.stl", stl_text(normal)))) << normal;
    EXPECT_UNREADABLE("a.stl", stl_text(" normal 0 0 1 1"), "a.stl:2", "1", "outer");
}

TEST(OddFiles, PointsMayHaveTwoOrMoreCoordinates) {
    const Places plane{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const std::string faces = "3 0 1 2\n3 0 2 3\n", planar = "0 0\n1 0\n1 1\n0 1\n";
    for (const auto& text : {"OFF\n4 2 0\n" + planar + faces, "nOFF\n2\n4 2 0\n" + planar + faces,
                             "CnOFF 2 4 2 0\n0 0 1 1 1 1\n1 0\n1 1\n0 1\n" + faces,
                             "OFF # plane\n4 2 0\n0 0 # first\n1 0\n1 1\n0 1\n" + faces}) {
        const Mesh mesh = read_from("a.off", text);
        EXPECT_EQ(rows(mesh.points), plane);
        EXPECT_EQ(rows(mesh.simplices), two_triangles);
    }
    EXPECT_EQ(rows(read_from("a.obj", "v 0 0\nv 1 0\nv 1 1\nv 0 1\nf 1 2 3\nf 1 3 4\n").points),
              plane);
    EXPECT_EQ(rows(read_from("a.ply", "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
                                      "property float y\nelement face 2\nproperty list uchar int "
                                      "vertex_indices\nend_header\n" +
                                          planar + faces)
                       .points),
              plane);
    const std::string space = "0 0 0 1\n1 0 0 1\n0 1 0 1\n";
    const Places four{{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}};
    EXPECT_EQ(rows(read_from("a.off", "4OFF\n3 1 0\n" + space + "3 0 1 2\n").points), four);
    EXPECT_EQ(rows(read_from("a.off", "nOFF\n4\n3 1 0\n" + space + "3 0 1 2\n").points), four);
    EXPECT_EQ(rows(read_from("a.off", "ST4nOFF 3\n3 1 0\n" + space + "3 0 1 2\n").points), four);
    // Three coordinates may stand in any lines.
    EXPECT_EQ(read_from("a.off", "OFF\n3 1 0\n0 0\n0\n1 0\n0\n0 1\n0\n3 0 1 2\n").points.cols(), 3);
}

TEST(OddFiles, FortranWritesExponentsBehindAD) {
    const std::string start = "MeshVersionFormatted 2\nDimension 2\nVertices 3\n0.1D+01 -2d0 0\n";
    const std::string cells = "Triangles 1\n1 2 3 0\n";
    EXPECT_EQ(rows(read_from("a.mesh", start + "+1.5D-3 0. 0\n1D-400 5d2 0\n" + cells).points),
              (Places{{1, -2}, {1.5e-3, 0}, {0, 500}}));
    for (const char* number : {"1D", "1D+", "1D2D3", "D1", "1D2e3"})
        EXPECT_UNREADABLE("a.mesh", start + "0 0 0\n0 " + number + " 0\n" + cells, "a.mesh:6",
                          "not a number", "coordinate")
            << number;
    EXPECT_UNREADABLE("a.mesh", start + "0 0 0\n0 1D400 0\n" + cells, "a.mesh:6",
                      "outside the range of double precision");
}

TEST(OddFiles, AnotherFormatSaysWhichItIs) {
    EXPECT_UNREADABLE("a.off",
                      "version https://git-lfs.github.com/spec/v1\noid sha256:0\n"
                      "size 12\n",
                      "a.off", "Git LFS", "git lfs pull");
    EXPECT_UNREADABLE("a.mesh", "MFEM mesh v1.0\n\ndimension\n2\n", "a.mesh", "MFEM");
    EXPECT_UNREADABLE("a.obj", "ply\nformat ascii 1.0\n", "a.obj", "PLY", ".ply");
    EXPECT_UNREADABLE("a.vtk", "<?xml version=\"1.0\"?>\n<!-- x -->\n<VTKFile>\n", "a.vtk", "XML",
                      ".vtu");
    EXPECT_UNREADABLE("a.stl", "<!DOCTYPE html>\n<html>404</html>\n", "a.stl", "HTML");
    EXPECT_UNREADABLE("a.ply", std::string("\x1F\x8B\x08\0", 4), "a.ply", "gzip", "unpack");
    EXPECT_UNREADABLE("a.msh", "\x89HDF\r\n", "a.msh", "HDF5");
    EXPECT_UNREADABLE("a.msh", "4 2 4\n0 0 1\n", "a.msh", "FreeFEM", ".mesh");
    // What is of its format has its own error.
    EXPECT_UNREADABLE("a.off", "OFF\n1 1 0\n", "a.off:3", "ends");
}

TEST(OddFiles, PiecesOfAGridAreOneMesh) {
    const auto piece = [](const std::string& places, const std::string& tag) {
        return "<Piece NumberOfPoints=\"3\" NumberOfCells=\"1\"><CellData><DataArray "
               "type=\"Int32\" "
               "Name=\"material\" format=\"ascii\">" +
               tag +
               "</DataArray></CellData><Points><DataArray type=\"Float64\" "
               "NumberOfComponents=\"3\" "
               "format=\"ascii\">" +
               places +
               "</DataArray></Points><Cells><DataArray type=\"Int32\" Name=\"connectivity\" "
               "format=\"ascii\">0 1 2</DataArray><DataArray type=\"Int32\" Name=\"offsets\" "
               "format=\"ascii\">3</DataArray><DataArray type=\"UInt8\" Name=\"types\" "
               "format=\"ascii\">5</DataArray></Cells></Piece>";
    };
    const auto file = [](const std::string& pieces) {
        return "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">"
               "<UnstructuredGrid>" +
               pieces + "</UnstructuredGrid></VTKFile>";
    };
    const std::string empty = "<Piece NumberOfPoints=\"0\" NumberOfCells=\"0\"></Piece>";
    const auto mesh = read_from(
        "a.vtu", file(piece("0 0 0 1 0 0 1 1 0", "4") + empty + piece("0 0 0 1 1 0 0 1 0", "5")));
    EXPECT_EQ(mesh.points.rows(), 6);
    EXPECT_EQ(rows(mesh.simplices), (Cells{{0, 1, 2}, {0, 2, 5}}));
    EXPECT_EQ(mesh.tags, (std::vector<Index>{4, 5}));
    EXPECT_EACH_SAYS(mesh.warnings, {"joined 2 vertices", "pieces"});
    std::string bare = piece("0 0 0 1 1 0 0 1 0", "5");
    bare.erase(bare.find("<CellData>"), bare.find("<Points>") - bare.find("<CellData>"));
    EXPECT_EQ(read_from("a.vtu", file(piece("0 0 0 1 0 0 1 1 0", "4") + bare)).tags,
              (std::vector<Index>{4, 0}));
    // A slit within a piece stays one.
    const auto slit =
        read_from("a.vtu", file(piece("0 0 0 1 0 0 0 0 0", "4") + piece("0 0 0 1 1 0 0 1 0", "5")));
    EXPECT_EQ(rows(slit.simplices), (Cells{{0, 1, 2}, {3, 4, 5}}));
    const auto bad = piece("0 0 0 1 1 0 0 1 0", "5");
    std::string beyond = bad;
    beyond.replace(beyond.find("0 1 2<"), 5, "0 1 3");
    EXPECT_UNREADABLE("a.vtu", file(beyond + bad), "a.vtu:1", "piece 0", "vertex", "3", "0", "2");
}

} // namespace polydec::test::in_odd_files
