// SPDX-License-Identifier: MIT
#include "io/readers.h"
#include "io/write_mesh.h"
#include "tests/io/support.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <random>
#include <sys/resource.h>
#include <unistd.h>

namespace polydec::tests {

namespace {

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

std::vector<Seed> seeds() {
    Mesh tetrahedra;
    tetrahedra.points = Points(5, 3);
    tetrahedra.points << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1.5, 1e-3, -7;
    tetrahedra.simplices = Simplices(2, 4);
    tetrahedra.simplices << 0, 1, 2, 3, 1, 2, 3, 4;
    Mesh triangles;
    triangles.points = tetrahedra.points;
    triangles.simplices = Simplices(3, 3);
    triangles.simplices << 0, 1, 2, 1, 2, 3, 2, 3, 4;
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

/// Whatever is read is usable: finite, with every vertex number in range.
void read_and_check(const SourceFile& file) {
    if (file.name == "a.mtx") {
        ASSERT_TRUE(DenseMatrix(parse_matrix_market(file).topRows(1)).allFinite());
    } else if (file.name == "a.vec") {
        ASSERT_TRUE(parse_matrix_market_array(file).allFinite());
    } else {
        const auto mesh = parse_mesh(file);
        ASSERT_GT(mesh.simplices.rows(), 0);
        ASSERT_TRUE(mesh.points.allFinite());
        ASSERT_GE(mesh.simplices.minCoeff(), 0);
        ASSERT_LT(mesh.simplices.maxCoeff(), mesh.points.rows());
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

} // namespace

TEST(Mutations, SeedsAreValid) {
    const MemoryLimit limit;
    for (const auto& [name, text] : seeds()) {
        EXPECT_EQ(error_of([seed = SourceFile{name, text}] { read_and_check(seed); }), "");
    }
}

TEST(Mutations, FilesCutOffAtEveryByteSurvive) {
    const MemoryLimit limit;
    for (const auto& [name, text] : seeds()) {
        for (std::size_t size = 0; size < text.size(); ++size) {
            expect_survival(name, text.substr(0, size));
        }
    }
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
            if (is_space(text[begin]) || (begin > 0 && !is_space(text[begin - 1]))) {
                continue;
            }
            const auto end = std::min(text.find_first_of(" \n", begin), text.size());
            for (const auto& word : evil_words) {
                expect_survival(name, text.substr(0, begin) + word + text.substr(end));
            }
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
        {"a.mesh", "Dimension 3 Vertices 2000000000 0 0 0 0\n"},
        {"a.mesh", "Dimension 3 Vertices 1 0 0 0 0 Tetrahedra 2000000000\n1 1 1 1 0\n"},
        {"a.stl", std::string(80, ' ') + "\xFF\xFF\xFF\xFF"},
        {"a.mtx",
         "%%MatrixMarket matrix coordinate real general\n2000000000 2000000000 1\n1 1 1\n"},
        {"a.vec", "%%MatrixMarket matrix array real general\n2000000000 2000000000\n1\n"},
    };
    for (const auto& [name, text] : promises) {
        const auto error = error_of([seed = SourceFile{name, text}] { read_and_check(seed); });
        EXPECT_EQ(error.find("InvalidInput: "), 0U) << text << error;
    }
}

} // namespace polydec::tests
