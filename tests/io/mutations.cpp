// SPDX-License-Identifier: MIT
#include "io/matrices/parse_matrix_market.h"
#include "io/meshes/readers.h"
#include "tests/io/bytes.h"
#include "tests/io/support.h"

#include <sys/resource.h>

namespace polydec::test::in_mutations {

/// A small valid file of every format, to be damaged.
struct Seed {
    std::string name;
    std::string text;
};

std::string written(const std::string& name, const auto& mesh) {
    const TemporaryFolder folder;
    write_mesh(folder.path(name), mesh);
    return read_text(folder.path(name));
}

std::string binary_ply(bool big) {
    std::string text = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                       "_endian 1.0\nelement vertex 4\nproperty float x\nproperty uchar q\n"
                       "property float y\nproperty float z\nproperty list uchar short l\n"
                       "element face 2\nproperty list uchar int vertex_indices\nend_header\n";
    for (int i = 0; i < 4; ++i) {
        text += std::string("\0\1\0\0", 4) + "q" + std::string("\0\0\2\0\0\0\0\3", 8);
        text += std::string("\2abcd", 5);
    }
    for (int i = 0; i < 2; ++i) {
        text += '\3';
        for (const char corner : {0, 1, 2 + i}) {
            const char number[4] = {big ? '\0' : corner, 0, 0, big ? corner : '\0'};
            text.append(number, 4);
        }
    }
    return text;
}

/// Between the two files of a mesh of TetGen.
const std::string cut = "----\n";

const std::string node_numbers = "$Nodes\n4\n1 0 0 0\n2 1 0 0\n9 0 1 0\n4 0 0 1\n$EndNodes\n";
const std::string msh_header = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const std::string new_msh_header = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
const std::string vtk_header = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET ";

/// One tetrahedron of Gmsh's version 4.1 in bytes.
std::string binary_msh(std::endian order) {
    const auto integers = [order](const std::vector<int>& values) {
        return bytes_of_all<std::int32_t>(values, order);
    };
    const auto sizes = [order](const std::vector<int>& values) {
        return bytes_of_all<std::int64_t>(values, order);
    };
    const auto reals = [order](const std::vector<int>& values) {
        return bytes_of_all<double>(values, order);
    };
    const std::string entities = sizes({0, 0, 0, 1}) + integers({1}) + reals({0, 0, 0, 1, 1, 1}) +
                                 sizes({1}) + integers({7}) + sizes({0});
    const std::string nodes = sizes({1, 4, 1, 9}) + integers({3, 1, 0}) + sizes({4, 1, 2, 9, 4}) +
                              reals({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
    const std::string elements =
        sizes({1, 1, 1, 1}) + integers({3, 1, 4}) + sizes({1, 1, 1, 2, 9, 4});
    return "$MeshFormat\n4.1 1 8\n" + integers({1}) + "\n$EndMeshFormat\n$Entities\n" + entities +
           "\n$EndEntities\n$Nodes\n" + nodes + "\n$EndNodes\n$Elements\n" + elements +
           "\n$EndElements\n";
}

/// One triangle with a tag as a legacy VTK file in bytes.
std::string binary_vtk() {
    const auto integers = [](const std::vector<int>& values) {
        return bytes_of_all<std::int32_t>(values, std::endian::big) + "\n";
    };
    return "# vtk DataFile Version 4.2\nx\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 float\n" +
           bytes_of_all<float>(std::vector<int>{0, 0, 0, 1, 0, 0, 0, 1, 0}, std::endian::big) +
           "\nCELLS 1 4\n" + integers({3, 0, 1, 2}) + "CELL_TYPES 1\n" + integers({5}) +
           "CELL_DATA 1\nFIELD x 1\nmaterial 1 1 int\n" + integers({7});
}

std::string written_vtu(const PolygonMesh& polygons) {
    VtuGrid grid;
    grid.points = polygons.points;
    for (Index face = 0; face < polygons.size(); ++face)
        add_cell(grid, VtuCell::polygon, polygons.face(face));
    const TemporaryFolder folder;
    write_vtu(folder.path("a.vtu"), grid);
    return read_text(folder.path("a.vtu"));
}

/// One tetrahedron, its arrays compressed by zlib.
std::string compressed_vtu() {
    const std::string array = "<DataArray format='binary' type='";
    return "<VTKFile type='UnstructuredGrid' compressor='vtkZLibDataCompressor'>\n"
           "<UnstructuredGrid><Piece NumberOfPoints='4' NumberOfCells='1'><Points>" +
           array +
           "Float32'>\nAQAAADAAAAAAAAAAEAAAAA==eNpjYEAGDfYMBPgAJ70CPg=="
           "</DataArray></Points>\n<Cells>" +
           array +
           "Int32' "
           "Name='connectivity'>AQAAABAAAAAAAAAAEwAAAA==eNpjYGBgYARiJiBmBmIAADgABw==</"
           "DataArray>\n" +
           array + "Int32' Name='offsets'>AQAAAAQAAAAAAAAADAAAAA==eNpjYWBgAAAAFAAF</DataArray>\n" +
           array + "UInt8' Name='types'>AQAAAAEAAAAAAAAACQAAAA==eNrjAgAACwAL</DataArray>\n" +
           "</Cells></Piece></UnstructuredGrid></VTKFile>\n";
}

/// Appended arrays, with an array that is not read between them.
std::string appended_vtu(bool is_raw) {
    const auto bytes = [](const auto& numbers, auto one) {
        const auto body = bytes_of_all<decltype(one)>(numbers, std::endian::little);
        return bytes_of(static_cast<std::uint32_t>(body.size()), std::endian::little) + body;
    };
    const std::array pieces{bytes(std::vector<int>{0, 0, 0, 1, 0, 0, 0, 1, 0}, float{}),
                            bytes(std::vector<int>{0, 1, 2}, std::int32_t{}),
                            bytes(std::vector<int>{3}, std::int64_t{}),
                            bytes(std::vector<int>{5}, std::uint8_t{})};
    const std::array heads{"Float32'", "Int32' Name='connectivity'", "Int64' Name='offsets'",
                           "UInt8' Name='types'"};
    std::string text = "<VTKFile type='UnstructuredGrid'><UnstructuredGrid>"
                       "<Piece NumberOfPoints='3' NumberOfCells='1'>";
    std::string data;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const std::string outer = i == 0 ? "Points" : "Cells";
        text += "\n<" + outer + "><DataArray format='appended' offset='" +
                std::to_string(data.size()) + "' type='" + heads[i] + "/></" + outer + ">";
        data += is_raw ? pieces[i] : base64(pieces[i]);
    }
    return text + "</Piece></UnstructuredGrid>\n<AppendedData encoding='" +
           (is_raw ? "raw" : "base64") + "'>\n_" + data + "\n</AppendedData></VTKFile>\n";
}

std::vector<Seed> seeds() {
    Mesh tetrahedra = made_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1.5, 1e-3, -7}},
                              {{0, 1, 2, 3}, {1, 2, 3, 4}});
    Mesh triangles;
    triangles.points = tetrahedra.points;
    triangles.simplices = Simplices{{0, 1, 2}, {1, 2, 3}, {2, 3, 4}};
    PolygonMesh polygons;
    polygons.points = triangles.points;
    polygons.corners = {0, 1, 2, 3, 4, 0, 2, 1};
    polygons.offsets = {0, 5, 8};

    return {
        {"a.off", written("a.off", polygons)},
        {"a.obj", written("a.obj", polygons) + "f -1/2/3 -2//1 \\\n 1/2\nl 1 2\n# end\n"},
        {"a.ply", written("a.ply", polygons)},
        {"a.ply", binary_ply(false)},
        {"a.ply", binary_ply(true)},
        {"a.stl", written("a.stl", triangles)},
        {"a.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                  "vertex 0 1 0\nendloop\nendfacet\nendsolid a\n"},
        {"a.nsc", written("a.nsc", tetrahedra)},
        {"a.mesh", written("a.mesh", tetrahedra)},
        {"a.mesh", written("a.mesh", triangles)},
        {"a.msh", msh_header + node_numbers +
                      "$Elements\n2\n1 3 2 7 1 1 2 9 4\n2 2 0 1 2 4\n"
                      "$EndElements\n"},
        {"a.msh", new_msh_header + "$Entities\n0 0 0 1\n1 0 0 0 1 1 1 1 7 1 -3\n$EndEntities\n"
                                   "$Nodes\n1 4 1 9\n3 1 0 4\n1\n2\n9\n4\n0 0 0\n1 0 0\n0 1 0\n"
                                   "0 0 1\n$EndNodes\n$Elements\n1 1 1 1\n3 1 4 1\n1 1 2 9 4\n"
                                   "$EndElements\n"},
        {"a.msh", binary_msh(std::endian::little)},
        {"a.msh", binary_msh(std::endian::big)},
        {"a.node", "4 3 1 1\n1 0 0 0 5 1\n2 1 0 0 5 1\n3 0 1 0 5 1\n4 0 0 1 5 1\n" + cut +
                       "1 4 1\n1 1 2 3 4 7\n"},
        {"a.vtk", vtk_header + "UNSTRUCTURED_GRID\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 0 0 1\n"
                               "CELLS 2 9\n4 0 1 2 3\n3 0 1 2\nCELL_TYPES 2\n10 5\nCELL_DATA 2\n"
                               "SCALARS material int 1\nLOOKUP_TABLE default\n1 2\n"},
        {"a.vtk", vtk_header + "POLYDATA\nPOINTS 4 float\n0 0 0 1 0 0 0 1 0 1 1 0\nPOLYGONS 1 5\n"
                               "4 0 1 3 2\nPOINT_DATA 1\nVECTORS v float\n1 2 3\n"},
        {"a.vtk", "# vtk DataFile Version 5.1\nx\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n"
                  "0 0 0 1 0 0 0 1 0\nTRIANGLE_STRIPS 2 3\nOFFSETS vtktypeint64\n0 3\n"
                  "CONNECTIVITY vtktypeint64\n0 1 2\nMETADATA\nINFORMATION 0\n\n"},
        {"a.vtk", binary_vtk()},
        {"a.vtu", written_vtu(polygons)},
        {"a.vtu", compressed_vtu()},
        {"a.vtu", appended_vtu(false)},
        {"a.vtu", appended_vtu(true)},
        {"a.nsl", "# c\n2 4 2 5\n0 1 2\n0 2 3\n0 1 1\n2 0 1.5\n1 2 1\n3 2 1e0\n0 3 1\n"},
        {"a.mtx", "%%MatrixMarket matrix coordinate real symmetric\n% c\n4 4 3\n1 1 5\n2 1 -1e3\n"
                  "4 3 .5\n"},
        {"a.vec", "%%MatrixMarket matrix array real general\n3 1\n1\n2\n3\n"},
    };
}

/// While it lives, a gigabyte more than now is all there is: what is asked for beyond it fails, and
/// is then reported as an IoError, even if it would never have been touched.
class MemoryLimit {
public:
    MemoryLimit() {
        std::size_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        ::getrlimit(RLIMIT_AS, &before_);
        rlimit limit = before_;
        limit.rlim_cur = pages * static_cast<std::size_t>(::getpagesize()) + (1U << 30U);
        ::setrlimit(RLIMIT_AS, &limit);
    }
    ~MemoryLimit() { ::setrlimit(RLIMIT_AS, &before_); }
    MemoryLimit(const MemoryLimit&) = delete;
    MemoryLimit& operator=(const MemoryLimit&) = delete;

private:
    rlimit before_{};
};

/// Finite, with every vertex number in range, and with a tag for every cell or none.
void check(const Mesh& mesh) {
    ASSERT_TRUE(mesh.points.allFinite());
    ASSERT_NO_THROW(check_facet_tags(mesh));
    ASSERT_TRUE(mesh.tags.empty() ||
                static_cast<Eigen::Index>(mesh.tags.size()) == mesh.simplices.rows());
    if (mesh.simplices.size() > 0) {
        ASSERT_GE(mesh.simplices.minCoeff(), 0);
        ASSERT_LT(mesh.simplices.maxCoeff(), mesh.points.rows());
    }
}

/// Whatever is read is usable.
void read_and_check(const SourceFile& file) {
    if (file.name == "a.mtx") {
        ASSERT_TRUE(DenseMatrix(parse_matrix_market(file).topRows(1)).allFinite());
    } else if (file.name == "a.vec") {
        ASSERT_TRUE(parse_matrix_market_array(file).allFinite());
    } else if (file.name == "a.nsl") {
        const auto mesh = parse_lengths(file);
        ASSERT_EQ(error_of([&] { polydec::check(mesh); }), "");
        ASSERT_TRUE(mesh.lengths.allFinite());
        ASSERT_GT(mesh.lengths.minCoeff(), 0);
    } else if (file.name == "a.node") {
        const auto place = std::min(file.text.find(cut), file.text.size());
        const auto rest = file.text.substr(std::min(place + cut.size(), file.text.size()));
        check(parse_tetgen({file.name, file.text.substr(0, place)}, {SourceFile{file.name, rest}}));
    } else {
        const auto mesh = parse_mesh(file);
        ASSERT_GT(mesh.simplices.rows(), 0);
        check(mesh);
    }
}

/// Reads a damaged file, which must give a usable mesh or an InvalidInput that names the file.
void expect_survival(const std::string& name, const std::string& text) {
    const auto error = error_of([&] { read_and_check({name, text}); });
    if (!error.empty()) {
        ASSERT_EQ(error.find("InvalidInput: " + name + ":"), 0U) << error;
        ASSERT_LT(error.size(), 1000U);
    }
}

const std::array<std::string, 12> evil_words{
    "-1",          "0",     "4294967295", "2147483648", "1000000000000000000000",
    "nan",         "-inf",  "1e999",      "x",          "2147483647",
    "-2147483648", "1e-999"};

bool is_space(char c) {
    return c == ' ' || c == '\n';
}

TEST(Mutations, SeedsAreValid) {
    const MemoryLimit limit;
    for (const auto& [name, text] : seeds())
        EXPECT_EQ(error_of([seed = SourceFile{name, text}] { read_and_check(seed); }), "");
}

TEST(Mutations, FilesCutOffAtEveryByteSurvive) {
    const MemoryLimit limit;
    for (const auto& [name, text] : seeds())
        for (std::size_t size = 0; size < text.size(); ++size)
            expect_survival(name, text.substr(0, size));
}

TEST(Mutations, EveryByteMayBeAnything) {
    const MemoryLimit limit;
    for (const auto& [name, text] : seeds()) {
        for (std::size_t place = 0; place < text.size(); ++place) {
            for (const int byte : {0, 10, 13, 32, 35, 45, 57, 92, 128, 255}) {
                auto damaged = text;
                damaged[place] = static_cast<char>(byte);
                expect_survival(name, damaged);
            }
        }
    }
}

TEST(Mutations, EveryWordMayBeAnything) {
    const MemoryLimit limit;
    for (const auto& [name, text] : seeds()) {
        for (std::size_t begin = 0; begin < text.size(); ++begin) {
            if (is_space(text[begin]) || (begin > 0 && !is_space(text[begin - 1])))
                continue;
            const auto end = std::min(text.find_first_of(" \n", begin), text.size());
            for (const auto& word : evil_words)
                expect_survival(name, text.substr(0, begin) + word + text.substr(end));
        }
    }
}

TEST(Mutations, ManyChangesAtRandomSurvive) {
    const TemporaryFolder folder;
    std::mt19937 random(20240607);
    const MemoryLimit limit;
    for (const auto& [name, text] : seeds()) {
        for (int round = 0; round < 300; ++round) {
            auto damaged = text;
            for (int change = 0; change < 4 && !damaged.empty(); ++change) {
                const auto place = random() % damaged.size();
                const auto length = std::min<std::size_t>(random() % 8, damaged.size() - place);
                const auto source = random() % damaged.size();
                damaged.replace(place, length, damaged.substr(source, random() % 8));
            }
            expect_survival(name, damaged);
        }
    }
}

TEST(Mutations, PromisedCountsAllocateNothing) {
    const MemoryLimit limit;
    const std::vector<Seed> promises{
        {"a.off", "OFF\n2000000000 1 0\n0 0 0\n"},
        {"a.off", "OFF\n1 2000000000 0\n0 0 0\n3 0 0 0\n"},
        {"a.off", "OFF\n1 1 0\n0 0 0\n2000000000 0 0\n"},
        {"a.ply",
         "ply\nformat ascii 1.0\nelement vertex 2000000000\nproperty float x\nproperty float "
         "y\nproperty float z\nend_header\n0 0 0\n"},
        {"a.ply", "ply\nformat binary_little_endian 1.0\nelement vertex 2000000000\nend_header\n"},
        {"a.ply", "ply\nformat ascii 1.0\nelement face 2000000000\nend_header\n"},
        {"a.nsc", "3 3 2000000000 1\n0 0 0\n"},
        {"a.nsc", "3 3 1 2000000000\n0 0 0\n0 0 0 0\n"},
        {"a.nsl", "2 2000000000 1 3\n0 1 2\n"},
        {"a.nsl", "2 3 2000000000 3\n0 1 2\n"},
        {"a.nsl", "2 3 1 2000000000\n0 1 2\n0 1 1\n"},
        {"a.nsl", "2000000000 3 1 3\n0 1 2\n"},
        {"a.mesh", "Dimension 3 Vertices 2000000000 0 0 0 0\n"},
        {"a.mesh", "Dimension 3 Vertices 1 0 0 0 0 Tetrahedra 2000000000\n1 1 1 1 0\n"},
        {"a.stl", std::string(80, ' ') + "\xFF\xFF\xFF\xFF"},
        {"a.msh", msh_header + "$Nodes\n2000000000\n1 0 0 0\n"},
        {"a.msh", msh_header + node_numbers + "$Elements\n2000000000\n1 4 0 1 2 9 4\n"},
        {"a.msh", msh_header + node_numbers + "$Elements\n1\n1 4 2000000000 1 2 9 4\n"},
        {"a.msh", new_msh_header + "$Nodes\n1 2000000000 1 1\n2 1 0 2000000000\n"},
        {"a.msh", new_msh_header + "$Nodes\n2000000000 0 1 1\n$EndNodes\n"},
        {"a.msh", new_msh_header + "$Entities\n2000000000 0 0 0\n1 0 0 0 2000000000\n"},
        {"a.node", "2000000000 3 0 0\n0 0 0 0\n" + cut},
        {"a.node", "1 3 0 0\n0 0 0 0\n" + cut + "2000000000 4 0\n"},
        {"a.node", "1 3 0 0\n0 0 0 0\n" + cut + "2 4 2000000000\n0 0 0 0 0\n"},
        {"a.vtk", vtk_header + "POLYDATA\nPOINTS 2000000000 float\n0 0 0\n"},
        {"a.vtk", vtk_header + "POLYDATA\nPOINTS 1 float\n0 0 0\nPOLYGONS 2000000000 1\n0\n"},
        {"a.vtk", vtk_header + "POLYDATA\nPOINTS 1 float\n0 0 0\nPOLYGONS 1 2000000000\n3 0\n"},
        {"a.vtk", vtk_header + "POLYDATA\nFIELD x 2000000000\na 2000000000 2000000000 int\n"},
        {"a.vtu", "<VTKFile type='UnstructuredGrid'><Points><DataArray format='binary' "
                  "type='Int8'>////////</DataArray></Points><Cells><DataArray "
                  "Name='connectivity'/></Cells></VTKFile>"},
        {"a.vtu", "<VTKFile type='UnstructuredGrid' compressor='vtkZLibDataCompressor'><Points>"
                  "<DataArray format='binary' type='Int8'>" +
                      base64(std::string(7, '\x7F') + std::string(9, '\1')) +
                      "</DataArray></Points></VTKFile>"},
        {"a.mtx",
         "%%MatrixMarket matrix coordinate real general\n2000000000 2000000000 1\n1 1 1\n"},
        {"a.vec", "%%MatrixMarket matrix array real general\n2000000000 2000000000\n1\n"},
    };
    for (const auto& [name, text] : promises) {
        const auto error = error_of([seed = SourceFile{name, text}] { read_and_check(seed); });
        EXPECT_EQ(error.find("InvalidInput: "), 0U) << text << error;
    }
}

} // namespace polydec::test::in_mutations
