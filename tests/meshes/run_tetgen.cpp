// SPDX-License-Identifier: MIT
#include "meshes/tetgen/run_tetgen.h"

#include "tests/meshes/propositions.h"
#include "tests/meshes/tetgen_support.h"

namespace polydec::test::in_run_tetgen {

namespace fs = std::filesystem;

TEST_F(TetgenTest, volumes_are_bounded_if_asked_for) {
    with_tetgen([] {
        const auto largest = [](const MesherOptions& options) {
            return cell_volumes(tetrahedralize(cube(1e3), options)).maxCoeff();
        };
        EXPECT_LE(largest({.largest_volume = 1e7}), 1e7 * (1 + 1e-12));
        EXPECT_GT(largest({}), 1e7);
    });
}

TEST_F(TetgenTest, parts_within_are_filled_unless_they_are_holes) {
    with_tetgen([] {
        const auto surface = united(cube(), cube(0.5, 0.25));
        EXPECT_NEAR(total_volume(tetrahedralize(surface)), 1.0, 1e-14);
        const Points hole = Points::Constant(1, 3, 0.5);
        EXPECT_NEAR(total_volume(tetrahedralize(surface, {}, hole)), 1.0 - 0.125, 1e-14);
    });
}

TEST_F(TetgenTest, thin_bodies_with_rounded_coordinates_are_filled) {
    with_tetgen([] {
        for (const double thickness : {1e-2, 1e-3}) {
            auto surface = cube();
            surface.points.col(2) *= thickness;
            const Eigen::Matrix3d turn =
                Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
            surface.points = (surface.points * turn).unaryExpr([](double x) {
                return std::round(x * 1e8) / 1e8; // eight digits, as in many files
            });
            EXPECT_NEAR(total_volume(tetrahedralize(surface)), thickness, 1e-7);
        }
    });
}

TEST_F(TetgenTest, scaling_by_a_power_of_two_scales_the_mesh_to_the_last_bit) {
    with_tetgen([] {
        const auto mesh = tetrahedralize(cube(), {.quality = 1.4, .largest_volume = 0.01});
        for (const int exponent : {-300, 300}) {
            const double scale = std::ldexp(1.0, exponent);
            const auto scaled = tetrahedralize(
                cube(scale), {.quality = 1.4, .largest_volume = 0.01 * scale * scale * scale});
            EXPECT_EQ(scaled.points, mesh.points * scale);
            EXPECT_EQ(scaled.simplices, mesh.simplices);
        }
    });
}

TEST_F(TetgenTest, facets_that_cross_are_named) {
    with_tetgen([] {
        Mesh spike;
        spike.points.resize(4, 3);
        spike.points << 0.7, 0.2, 0.5, 0.8, 0.2, 0.5, 0.7, 0.3, 0.5, 0.7, 0.2, 2;
        spike.simplices.resize(4, 3);
        spike.simplices << 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3;
        EXPECT_SAYS(refusal_of(united(cube(), spike)), "mesher", "3 pairs", "facets", "2 (4 5 7)",
                    "13 (8 9 11)", "2 (4 5 7)", "14 (8 11 10)", "2 (4 5 7)", "15 (9 10 11)");
    });
}

TEST_F(TetgenTest, points_that_tetgen_would_take_for_one_are_named) {
    with_tetgen([] {
        auto thin = cube();
        thin.points.col(2) *= 1e-10;
        EXPECT_ERROR(SolverFailure, tetrahedralize(thin), "tetgen", "left out", "point");
    });
}

TEST_F(TetgenTest, it_is_stopped_after_the_time_given) {
    with_tetgen([] {
        EXPECT_ERROR(SolverFailure,
                     tetrahedralize(cube(), {.largest_volume = 1e-9, .seconds = 0.01}), "tetgen",
                     "stopped", "0.01");
    });
}

TEST_F(TetgenTest, memory_that_does_not_suffice_is_told) {
    with_tetgen([] {
        const auto message = message_of<SolverFailure>([] {
            tetrahedralize(cube(), {.largest_volume = 1e-9, .bytes = std::size_t{100} << 20});
        });
        EXPECT_NE(message.find("memory"), std::string::npos) << message;
    });
}

TEST_F(TetgenTest, holes_that_take_everything_are_told) {
    with_tetgen([] {
        const Points hole = Points::Constant(1, 3, 0.5);
        EXPECT_ERROR(SolverFailure, tetrahedralize(cube(), {}, hole), "tetgen", "no tetrahedra",
                     "holes");
    });
}

TEST_F(TetgenTest, without_the_program_it_is_told_how_to_get_it) {
    const Variable path("PATH", "/nowhere");
    EXPECT_FALSE(is_available());
    EXPECT_ERROR(BackendUnavailable, tetrahedralize(cube()), missing);
}

/// Another program of that name, which does what the script says.
std::string failure_of(const std::string& script) {
    const TemporaryFolder folder;
    const auto program = folder.path() / "tetgen";
    std::ofstream(program) << "#!/bin/sh\n" << script << '\n';
    fs::permissions(program, fs::perms::owner_all);
    const Variable path("PATH", folder.path().string() + ":/usr/bin:/bin");
    return message_of<SolverFailure>([] { tetrahedralize(cube()); });
}

TEST_F(TetgenTest, a_crash_is_decoded) {
    EXPECT_SAYS(failure_of("echo broken; kill -SEGV $$"), "tetgen", "signal", "Segmentation fault",
                "broken");
    EXPECT_SAYS(failure_of("exit 3"), "tetgen", "exit code 3");
}

TEST_F(TetgenTest, output_that_is_none_is_refused) {
    const auto wrote = [](const std::string& points, const std::string& cells) {
        return failure_of("echo '" + points + "' > mesh.1.node; echo '" + cells + "' > mesh.1.ele");
    };
    const std::string tetrahedron = "4 3 0 0 0 0 0 0 1 1 0 0 2 0 1 0 3 0 0 1";
    EXPECT_SAYS(failure_of("exit 0"), "tetgen", "no tetrahedra", "plane");
    EXPECT_SAYS(wrote("", ""), "tetgen", "mesh.1.node", "missing", "1 bytes");
    EXPECT_SAYS(wrote("2000000000 3 0 0", ""), "tetgen", "mesh.1.node", "2000000000 rows",
                "17 bytes");
    EXPECT_SAYS(wrote("1 3 2147483647 1 0 0 0 0", ""), "tetgen", "mesh.1.node",
                "2147483647 more numbers", "row");
    EXPECT_SAYS(wrote(tetrahedron, "1 4 -1 0 0 1 2 3"), "tetgen", "mesh.1.ele", "-1 more numbers",
                "row");
    EXPECT_SAYS(wrote("1 3 0 0 0 nan 0 0", ""), "tetgen", "mesh.1.node", "point 0", "finite");
    EXPECT_SAYS(wrote(tetrahedron, "1 4 0 0 0 1 2 4"), "tetgen", "mesh.1.ele", "tetrahedron 0",
                "corner 4");
    EXPECT_SAYS(wrote(tetrahedron, "1 4 0 0 0 1"), "tetgen", "mesh.1.ele", "missing", "12 bytes");
    EXPECT_SAYS(wrote(tetrahedron, "1 4 0 0 0 1 2 3 4"), "tetgen", "mesh.1.ele", "end", "15 bytes");
    EXPECT_SAYS(wrote(tetrahedron, "1 4 0 0 0 1 2 3"), "tetgen", "mesh.1.face", "No such file");
    const std::string face = "; echo '1 1 0 0 1 2 1' > mesh.1.face";
    EXPECT_SAYS(failure_of("echo '" + tetrahedron +
                           "' > mesh.1.node; echo '1 4 0 0 0 1 2 3' > "
                           "mesh.1.ele" +
                           face),
                "tetgen", "left out", "point 3");
}

TEST_F(TetgenTest, only_regular_files_that_are_whole_are_read) {
    const auto wrote = [](const std::string& script) {
        return failure_of("echo > mesh.1.ele; " + script);
    };
    EXPECT_SAYS(wrote("mkfifo mesh.1.node"), "tetgen", "mesh.1.node", "regular file");
    EXPECT_SAYS(wrote("mkdir mesh.1.node"), "tetgen", "mesh.1.node", "regular file");
    EXPECT_SAYS(wrote("ln -s mesh.1.ele mesh.1.node"), "tetgen", "mesh.1.node", "symbolic links");
    EXPECT_SAYS(wrote("true"), "tetgen", "mesh.1.node", "No such file");
    EXPECT_SAYS(wrote("printf '1 3 0 0 0 1.2 3.4 5.6' > mesh.1.node"), "tetgen", "mesh.1.node",
                "end", "21 bytes");
}

} // namespace polydec::test::in_run_tetgen
