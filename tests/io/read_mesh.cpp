// SPDX-License-Identifier: MIT
#include "tests/io/support.h"
#include "tests/support/variable.h"

namespace polydec::test::in_read_mesh {

TEST(RealFiles, OfEveryFolderAreReadWhole) {
    struct File {
        const char* name;
        Index points, cells;
        double volume = 0;
    };
    for (const auto& [name, points, cells, volume] :
         std::vector<File>{{"bad/degenerate_mesh.obj", 3, 1},
                           {"bad/moebius.obj", 280, 448},
                           {"bad/non_manif_hole.ply", 432, 755},
                           {"bad/notenoughindices.obj", 3, 1},
                           {"bad/oblong-shuffled.off", 424, 840},
                           {"bad/soup.stl", 300, 100},
                           {"cad/casting.off", 5096, 10224},
                           {"cad/conrod.stl", 3223, 6442},
                           {"cad/featuretype.STL", 1722, 3476},
                           {"planar/2d_square_pi_x_pi.msh", 514, 946, 9.869604401089358},
                           {"poly/fandisk_quads.off", 766, 1528},
                           {"poly/horse_quad.obj", 2400, 4796},
                           {"poly/inspired_mesh_quads_Conjugate.off", 1749, 3266},
                           {"poly/mixedFaring.off", 2310, 4463},
                           {"surface/bob_small.ply", 250, 500},
                           {"table2/bun_zipper.ply", 35947, 69451},
                           {"table2/plane_5000.off", 2601, 5000},
                           {"tet/beam-tet.vtk", 36, 48, 8},
                           {"tet/cube.1.ele", 4550, 20981, 1},
                           {"tet/cube.1.node", 4550, 20981, 1},
                           {"tet/hand.mesh", 7234, 29998},
                           {"tet/icos.1.ele", 13, 20, 17.45276404266667},
                           {"tet/octopus-low.mesh", 452, 1140},
                           {"tet/test_mesh_3d.msh", 342, 1034, 4.0 / 3}})
        if (const auto path = test_datum(name)) {
            const auto mesh = read_mesh(*path);
            EXPECT_EQ(mesh.points.rows(), points) << name;
            EXPECT_EQ(mesh.simplices.rows(), cells) << name;
            if (volume > 0) {
                EXPECT_NEAR(total_volume(mesh), volume, 1e-12) << name;
            }
        }
}

TEST(RealFiles, AreMissedWhereThereAreOthers) {
    const TemporaryFolder folder;
    const Variable there_are_others("POLYDEC_TEST_DATA", folder.path().string());
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

} // namespace polydec::test::in_read_mesh
