// SPDX-License-Identifier: MIT
#include "io/matrices/parse_matrix_market.h"
#include "io/meshes/readers.h"
#include "tests/io/bytes.h"
#include "tests/io/support.h"

#include <sys/resource.h>

namespace polydec::test::in_mutations {

/// A file, which is damaged.
struct Seed {
    std::string name;
    std::string text;
};

/// Between the two files of a mesh of TetGen; an f behind it makes the second one those of faces.
const std::string cut = "---";

const std::string node_numbers = "$Nodes\n4\n1 0 0 0\n2 1 0 0\n9 0 1 0\n4 0 0 1\n$EndNodes\n";
const std::string msh_header = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const std::string new_msh_header = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
const std::string vtk_header = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET ";

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
        const auto matrix = parse_matrix_market(file);
        const Eigen::Map<const Vector> values(matrix.valuePtr(), matrix.nonZeros());
        ASSERT_TRUE(values.allFinite());
    } else if (file.name == "a.vec") {
        const auto matrix = parse_matrix_market_array(file);
        ASSERT_TRUE(matrix.size() == 0 || matrix.allFinite()); // many empty columns take long
    } else if (file.name == "a.nsl") {
        const auto mesh = parse_lengths(file);
        ASSERT_EQ(error_of([&] { polydec::check(mesh); }), "");
        ASSERT_TRUE(mesh.lengths.allFinite());
        ASSERT_TRUE((mesh.lengths.array() > 0).all());
    } else if (file.name == "a.node") {
        const auto place = std::min(file.text.find(cut), file.text.size());
        const auto rest = file.text.substr(std::min(place + cut.size(), file.text.size()));
        const bool is_face = rest.starts_with('f');
        check(parse_tetgen(
            {file.name, file.text.substr(0, place)},
            {SourceFile{is_face ? "a.node.face" : "a.node.ele", rest.substr(is_face)}}));
    } else {
        const auto mesh = parse_mesh(file);
        ASSERT_GT(mesh.simplices.rows(), 0);
        check(mesh);
    }
}

/// The valid files of every format in the corpora of the fuzzers, which are small.
std::vector<Seed> seeds() {
    const std::map<std::string, std::vector<std::string>> names{
        {"gmsh", {"a.msh"}},   {"matrix_market", {"a.mtx", "a.vec"}},
        {"medit", {"a.mesh"}}, {"nsc", {"a.nsc"}},
        {"nsl", {"a.nsl"}},    {"obj", {"a.obj"}},
        {"off", {"a.off"}},    {"ply", {"a.ply"}},
        {"stl", {"a.stl"}},    {"tetgen", {"a.node"}},
        {"vtk", {"a.vtk"}},    {"vtu", {"a.vtu"}}};
    const auto corpora =
        std::filesystem::path(POLYDEC_TEST_FILES).parent_path() / "fuzz" / "corpus";
    std::vector<Seed> valid;
    for (const auto& [folder, all] : names)
        for (const auto& entry : std::filesystem::directory_iterator(corpora / folder))
            for (const std::string& name : all) {
                const SourceFile file{name, read_text(entry.path())};
                if (error_of([&] { read_and_check(file); }).empty())
                    valid.push_back({name, file.text});
            }
    return valid;
}

/// Reads a damaged file, which must give a usable mesh or an InvalidInput that names the file.
void expect_survival(const std::string& name, const std::string& text) {
    const auto error = error_of([&] { read_and_check({name, text}); });
    if (!error.empty()) {
        const auto begin = "InvalidInput: " + name; // or that with .ele or .face behind it
        ASSERT_TRUE(error.starts_with(begin + ":") || error.starts_with(begin + ".")) << error;
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

TEST(Mutations, SeedsAreOfEveryFormat) {
    std::map<std::string, int> counts;
    for (const Seed& seed : seeds())
        ++counts[seed.name];
    EXPECT_EQ(counts.size(), 13U);
    EXPECT_GT(seeds().size(), 60U);
}

/// Whatever the capitals of the extension.
TEST(Mutations, LinesMayEndInThreeWays) {
    std::set<std::string> read;
    for (const auto& [name, text] : seeds()) {
        const bool is_mesh =
            name != "a.mtx" && name != "a.vec" && name != "a.nsl" && name != "a.node";
        const bool is_text = std::all_of(
            text.begin(), text.end(), [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); });
        if (!is_mesh || !is_text)
            continue;
        const auto mesh = parse_mesh({name, text});
        std::string loud = name;
        for (const char* line_break : {"\r\n", "\r"}) {
            const auto letter = std::find_if(loud.begin() + 1, loud.end(), ::islower);
            *letter = static_cast<char>(std::toupper(*letter)); // a.Off and a.OFf
            EXPECT_TRUE(same(mesh, parse_mesh({loud, with_line_breaks(text, line_break)}))) << text;
        }
        read.insert(name);
    }
    EXPECT_EQ(read.size(), 9U);
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
