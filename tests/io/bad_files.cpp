// SPDX-License-Identifier: MIT
#include "tests/io/support.h"

namespace polydec::test::in_bad_files {

/// A file and the expected result: words of the error message, or the number of cells.
struct Sample {
    std::string name;
    std::string text;
    Words error;
    Eigen::Index cells = 0;
};

const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
const std::string tetrahedron = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";

const std::vector<Sample> samples{
    {"hand_duplicate_face.off", "OFF\n4 3 0\n" + square + "3 0 1 2\n3 0 2 3\n3 0 1 2\n", {}, 3},
    {"hand_empty.off", "", {"InvalidInput", "hand_empty.off:1", "file ends", "OFF"}},
    {"hand_flat_tet.mesh",
     "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n1 1 0 0\n0 1 0 0\n"
     "Tetrahedra\n1\n1 2 3 4 0\nEnd\n",
     {},
     1},
    {"hand_huge_count.off",
     "OFF\n4000000000 4000000000 0\n0 0 0\n",
     {"InvalidInput", "hand_huge_count.off:2", "4000000000 vertices", "20 bytes", "4 bytes"}},
    {"hand_inconsistent_orientation.off", "OFF\n4 2 0\n" + square + "3 0 1 2\n3 0 3 2\n", {}, 2},
    {"hand_index_out_of_range.off",
     "OFF\n4 2 0\n" + square + "3 0 1 2\n3 0 2 4\n",
     {"InvalidInput", "hand_index_out_of_range.off:8", "vertex", "4", "range", "0", "3"}},
    {"hand_inverted_tet.mesh",
     "MeshVersionFormatted 2\nDimension 3\nVertices\n5\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n1 1 1 "
     "0\n"
     "Tetrahedra\n2\n1 2 3 4 0\n3 2 4 5 0\nEnd\n",
     {},
     2},
    {"hand_nan.off",
     "OFF\n4 2 0\n0 0 0\n1 0 0\nnan 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n",
     {"InvalidInput", "hand_nan.off:5", "vertex 2", "coordinate", "NaN"}},
    {"hand_negative_counts.off",
     "OFF\n-4 -2 0\n",
     {"InvalidInput", "hand_negative_counts.off:2", "-4 vertices", "at least 0"}},
    {"hand_negative_index.off",
     "OFF\n4 2 0\n" + square + "3 0 1 2\n3 0 2 -1\n",
     {"InvalidInput", "hand_negative_index.off:8", "vertex", "-1", "range", "0", "3"}},
    {"hand_no_faces.off",
     "OFF\n4 0 0\n" + square,
     {"InvalidInput", "hand_no_faces.off: ", "4 vertices", "no cells"}},
    {"hand_nonmanifold_edge.off",
     "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 -1 0\n0 0 1\n3 0 1 2\n3 1 0 3\n3 0 1 4\n",
     {},
     3},
    {"hand_repeated_index.off", "OFF\n4 2 0\n" + square + "3 0 1 2\n3 0 2 2\n", {}, 2},
    {"hand_truncated.off",
     "OFF\n4 4 0\n" + tetrahedron + "3 0 2 1\n3 0 1 3\n3 1 2 3\n",
     {"InvalidInput", "hand_truncated.off:10", "file ends", "3 of 4 faces"}},
    {"hand_truncated_midline.off",
     "OFF\n4 4 0\n" + tetrahedron + "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 ",
     {"InvalidInput", "hand_truncated_midline.off:10", "3 corners", "face", "3 bytes", "2 bytes"}},
    {"hand_zero_area.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 0 0\n3 0 1 2\n3 0 2 3\n", {}, 2},
    {"same_vertex_thrice.obj", "v 0 0 0\nv 0 0 0\nv 0 0 0\nf 3 2 1\n", {}, 1},
    {"not_finite.obj",
     "v inf nan +inf\nv nan -nan -Inf\nv 3.00 NaN -NaN\n\n# 3\n\nf 1 2 3\n",
     {"InvalidInput", "not_finite.obj:1", "vertex 0", "coordinate", "NaN"}},
    {"two_counts.off",
     "OFF\n3 4\n0.1 0.2 0.3\n0.2 0.3 0.4\n0.3 0.4 0.5\n0\n2\r20\n4\n",
     {"InvalidInput", "two_counts.off:3", "0.1", "whole number", "edges"}},
    {"index_zero.obj",
     "v 0 0 0\nv 1 0 0\nv 0 1 0\n\nusemtl Default\nf 3 12 1\nf 0 1 2\n",
     {"InvalidInput", "index_zero.obj:7", "vertex", "0", "range", "1", "3"}},
    {"two_corners.obj",
     "v -5 0 5\nv 5 0 5\nv 5 5 5\nusemtl M\ns 1\nf 1// 2//\nf 1// 2// 3//\n",
     {},
     1},
};

void expect_error(const std::string& error, const Words& words, const std::string& name) {
    if (words.empty()) {
        EXPECT_EQ(error, "") << name;
    } else {
        EXPECT_TRUE(says(error, words)) << name;
    }
}

void expect(const Sample& sample, const std::string& text) {
    const auto error = reading_error(sample.name, text);
    expect_error(error, sample.error, sample.name);
    if (error.empty()) {
        EXPECT_EQ(read_from(sample.name, text).simplices.rows(), sample.cells) << sample.name;
    }
}

TEST(BadFiles, AreReadOrRefusedByPlace) {
    for (const auto& sample : samples)
        expect(sample, sample.text);
}

TEST(BadFiles, RealOnesAreTheSame) {
    std::map<std::string, Words> errors{
        {"inf_nan.obj", {"InvalidInput", "inf_nan.obj:1", "vertex 0", "coordinate", "NaN"}},
        {"invalid_assimp.off",
         {"InvalidInput", "invalid_assimp.off:3", "0.1", "whole number", "edges"}},
        {"malformed_assimp.obj",
         {"InvalidInput", "malformed_assimp.obj:28", "vertex", "0", "range", "1", "8"}},
    };
    for (const auto& sample : samples)
        errors[sample.name] = sample.error;
    const std::map<std::string, Eigen::Index> cells{
        {"degenerate_mesh.obj", 1},   {"notenoughindices.obj", 1}, {"non_manif_hole.ply", 755},
        {"oblong-shuffled.off", 840}, {"moebius.obj", 448},        {"soup.stl", 100},
    };
    for (const auto& [name, count] : cells)
        test_datum("bad/" + name);
    for (const auto& path : test_data("bad")) {
        const auto name = path.filename().string();
        const auto text = read_text(path);
        const auto found = cells.find(name);
        expect_error(reading_error(name, text), errors[name], name);
        if (found != cells.end()) {
            EXPECT_EQ(read_from(name, text).simplices.rows(), found->second) << name;
        }
    }
}

TEST(RealFiles, OfEveryFolderAreReadWhole) {
    const std::map<std::string, std::pair<Eigen::Index, Eigen::Index>> sizes{
        {"table2/bun_zipper.ply", {35947, 69451}},
        {"table2/plane_5000.off", {2601, 5000}},
        {"poly/fandisk_quads.off", {766, 1528}},
        {"poly/inspired_mesh_quads_Conjugate.off", {1749, 3266}},
        {"poly/mixedFaring.off", {2310, 4463}},
        {"tet/hand.mesh", {7234, 29998}},
        {"tet/octopus-low.mesh", {452, 1140}},
        {"surface/bob_small.ply", {250, 500}},
        {"cad/conrod.stl", {3223, 6442}},
        {"cad/featuretype.STL", {1722, 3476}},
        {"cad/casting.off", {5096, 10224}},
        {"poly/horse_quad.obj", {2400, 4796}},
    };
    for (const auto& [name, size] : sizes) {
        if (const auto path = test_datum(name)) {
            const auto mesh = read_mesh(*path);
            EXPECT_EQ(mesh.points.rows(), size.first) << name;
            EXPECT_EQ(mesh.simplices.rows(), size.second) << name;
        }
    }
}

TEST(RealFiles, AreMissedWhereThereAreOthers) {
    const char* before = std::getenv("POLYDEC_TEST_DATA");
    const std::string kept = before == nullptr ? "" : before;
    const TemporaryFolder folder;
    ::setenv("POLYDEC_TEST_DATA", folder.path().c_str(), 1);
    EXPECT_FALSE(has_test_data());
    EXPECT_EQ(test_datum("a.off"), std::nullopt);
    EXPECT_TRUE(test_data(".").empty());
    std::filesystem::create_directory(folder.path("meshes"));
    const auto there = folder.write("meshes/a.off", "");
    EXPECT_TRUE(has_test_data());
    EXPECT_EQ(test_datum("a.off"), there);
    EXPECT_EQ(test_data("").size(), 1U);
    EXPECT_THROW(test_datum("b.off"), std::runtime_error);
    ::unsetenv("POLYDEC_TEST_DATA");
    EXPECT_FALSE(has_test_data());
    if (before != nullptr)
        ::setenv("POLYDEC_TEST_DATA", kept.c_str(), 1);
}

TEST(ReadMesh, RefusesUnknownExtensions) {
    const std::string known =
        ".off .obj .ply .stl .nsc .mesh .msh .node .ele .vtk .vtu .pdm, or .nsl";
    EXPECT_REFUSED(read_mesh("folder/a.xyz"), "folder/a.xyz:", "'.xyz'", "extension", known);
    EXPECT_REFUSED(read_mesh("a"), "a:", "''", "extension", known);
}

TEST(ReadMesh, SaysWhyAFileCannotBeRead) {
    const TemporaryFolder folder;
    const auto missing = folder.path("a.off");
    EXPECT_ERROR(IoError, read_mesh(missing), missing.string(), "No such file");
    std::filesystem::create_directory(missing);
    EXPECT_ERROR(IoError, read_mesh(missing), missing.string(), "regular file");
}

} // namespace polydec::test::in_bad_files
