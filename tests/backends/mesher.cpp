// SPDX-License-Identifier: MIT
#include "backends/mesher.h"

#include "base/decompositions.h"
#include "tests/backends/mesher_support.h"
#include "tests/support/says.h"

#include <Eigen/Geometry>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace polydec::test::in_mesher {
namespace {

namespace fs = std::filesystem;

MesherInput both(MesherInput a, const MesherInput& b) {
    const auto shift = static_cast<Index>(a.points.rows());
    const auto corners = static_cast<Index>(a.corners.size());
    a.points.conservativeResize(shift + b.points.rows(), 3);
    a.points.bottomRows(b.points.rows()) = b.points;
    for (const Index corner : b.corners)
        a.corners.push_back(corner + shift);
    for (std::size_t f = 1; f < b.offsets.size(); ++f)
        a.offsets.push_back(b.offsets[f] + corners);
    return a;
}

Eigen::Matrix3d edges(const MesherOutput& mesh, Eigen::Index cell) {
    Eigen::Matrix3d result;
    for (int j = 0; j < 3; ++j)
        result.row(j) = mesh.points.row(mesh.tetrahedra(cell, j + 1)) -
                        mesh.points.row(mesh.tetrahedra(cell, 0));
    return result;
}

Eigen::RowVector3d circumcenter(const MesherOutput& mesh, Eigen::Index cell) {
    const Eigen::Matrix3d matrix = edges(mesh, cell);
    const Eigen::Vector3d squares = 0.5 * matrix.rowwise().squaredNorm();
    const Eigen::Vector3d center = matrix.inverse() * squares;
    return center.transpose() + mesh.points.row(mesh.tetrahedra(cell, 0));
}

double volume(const MesherOutput& mesh) {
    double sum = 0.0;
    for (Eigen::Index i = 0; i < mesh.tetrahedra.rows(); ++i)
        sum += edges(mesh, i).determinant() / 6.0;
    return sum;
}

/// How deep a point lies in the circumsphere of a cell, at most; relative to its radius.
double deepest_intrusion(const MesherOutput& mesh) {
    double deepest = 0.0;
    for (Eigen::Index i = 0; i < mesh.tetrahedra.rows(); ++i) {
        const Eigen::RowVector3d center = circumcenter(mesh, i);
        const double radius = (mesh.points.row(mesh.tetrahedra(i, 0)) - center).norm();
        const double least = (mesh.points.rowwise() - center).rowwise().norm().minCoeff();
        deepest = std::max(deepest, 1.0 - least / radius);
    }
    return deepest;
}

TEST_F(MesherTest, squares_are_filled_with_their_corners_kept) {
    with_tetgen([] {
        const auto input = cube(0.7, 0.1);
        const auto mesh = tetrahedralize(input);
        EXPECT_EQ(mesh.points, input.points);
        EXPECT_NEAR(volume(mesh), 0.343, 1e-14);
        for (Eigen::Index i = 0; i < mesh.tetrahedra.rows(); ++i)
            EXPECT_GT(edges(mesh, i).determinant(), 0.0);
    });
}

TEST_F(MesherTest, the_hull_of_points_is_filled_by_delaunay_tetrahedra) {
    with_tetgen([] {
        MesherInput input;
        input.points = cloud(200);
        auto mesh = tetrahedralize(input);
        EXPECT_EQ(mesh.points, input.points);
        EXPECT_LT(deepest_intrusion(mesh), 1e-9);
        mesh.points(100, 0) += 0.3; // a point elsewhere is within spheres
        EXPECT_GT(deepest_intrusion(mesh), 1e-3);
    });
}

TEST_F(MesherTest, volumes_are_bounded_if_asked_for) {
    with_tetgen([] {
        const auto largest = [](const MesherOptions& options) {
            const auto mesh = tetrahedralize(cube(1e3), options);
            double most = 0.0;
            for (Eigen::Index i = 0; i < mesh.tetrahedra.rows(); ++i)
                most = std::max(most, edges(mesh, i).determinant() / 6.0);
            return most;
        };
        EXPECT_LE(largest({.largest_volume = 1e7}), 1e7 * (1 + 1e-12));
        EXPECT_GT(largest({}), 1e7);
    });
}

TEST_F(MesherTest, parts_within_are_filled_unless_they_are_holes) {
    with_tetgen([] {
        auto input = both(cube(), cube(0.5, 0.25));
        EXPECT_NEAR(volume(tetrahedralize(input)), 1.0, 1e-14);
        input.holes = Points::Constant(1, 3, 0.5);
        EXPECT_NEAR(volume(tetrahedralize(input)), 1.0 - 0.125, 1e-14);
    });
}

TEST_F(MesherTest, thin_bodies_with_rounded_coordinates_are_filled) {
    with_tetgen([] {
        for (const double thickness : {1e-2, 1e-3}) {
            auto input = cube();
            input.points.col(2) *= thickness;
            const Eigen::Matrix3d turn =
                Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
            input.points = (input.points * turn).unaryExpr([](double x) {
                return std::round(x * 1e8) / 1e8; // eight digits, as in many files
            });
            // squares that rounding has bent are triangles
            const auto squares = input.corners;
            input.corners.clear();
            input.offsets = {0};
            for (std::size_t i = 0; i < squares.size(); i += 4)
                for (const std::size_t j : {1U, 2U}) {
                    input.corners.insert(input.corners.end(),
                                         {squares[i], squares[i + j], squares[i + j + 1]});
                    input.offsets.push_back(static_cast<Index>(input.corners.size()));
                }
            EXPECT_NEAR(volume(tetrahedralize(input)), thickness, 1e-7);
        }
    });
}

TEST_F(MesherTest, scaling_by_a_power_of_two_scales_the_mesh_to_the_last_bit) {
    with_tetgen([] {
        const auto mesh = tetrahedralize(cube(), {.quality = 1.4, .largest_volume = 0.01});
        for (const int exponent : {-300, 300}) {
            const double scale = std::ldexp(1.0, exponent);
            const auto scaled = tetrahedralize(
                cube(scale), {.quality = 1.4, .largest_volume = 0.01 * scale * scale * scale});
            EXPECT_EQ(scaled.points, mesh.points * scale);
            EXPECT_EQ(scaled.tetrahedra, mesh.tetrahedra);
        }
    });
}

TEST_F(MesherTest, points_on_no_facet_are_left_out) {
    with_tetgen([] {
        auto input =
            both(both(MesherInput{.points = Points::Constant(1, 3, 9.0), .offsets = {0}}, cube()),
                 MesherInput{.points = Points::Constant(1, 3, 0.5), .offsets = {0}});
        EXPECT_EQ(tetrahedralize(input).points, cube().points);
    });
}

TEST_F(MesherTest, facets_that_cross_are_named) {
    with_tetgen([] {
        auto spike = cube();
        spike.points.conservativeResize(12, 3);
        spike.points.bottomRows(4) << 0.5, 0.5, 0.5, 0.6, 0.5, 0.5, 0.5, 0.6, 0.5, 0.5, 0.5, 2;
        for (const Index corner : {8, 10, 9, 8, 9, 11, 8, 11, 10, 9, 10, 11})
            spike.corners.push_back(corner);
        for (const Index offset : {27, 30, 33, 36})
            spike.offsets.push_back(offset);
        EXPECT_TRUE(
            says(refusal_of(spike), {"mesher", "3 pairs", "facets", "1 (4 5 7 6)", "7 (8 9 11)",
                                     "1 (4 5 7 6)", "8 (8 11 10)", "1 (4 5 7 6)", "9 (9 10 11)"}));
    });
}

TEST_F(MesherTest, points_that_tetgen_would_take_for_one_are_named) {
    with_tetgen([] {
        auto thin = cube();
        thin.points.col(2) *= 1e-10;
        EXPECT_TRUE(says(message_of<SolverFailure>([&] { tetrahedralize(thin); }),
                         {"tetgen", "left out", "point"}));
    });
}

TEST_F(MesherTest, it_is_stopped_after_the_time_given) {
    with_tetgen([] {
        EXPECT_TRUE(says(message_of<SolverFailure>([] {
                             tetrahedralize(cube(), {.largest_volume = 1e-9, .seconds = 0.01});
                         }),
                         {"tetgen", "stopped", "0.01"}));
    });
}

TEST_F(MesherTest, memory_that_does_not_suffice_is_told) {
    with_tetgen([] {
        const auto message = message_of<SolverFailure>([] {
            tetrahedralize(cube(), {.largest_volume = 1e-9, .bytes = std::size_t{100} << 20});
        });
        EXPECT_NE(message.find("memory"), std::string::npos) << message;
    });
}

TEST_F(MesherTest, holes_that_take_everything_are_told) {
    with_tetgen([] {
        auto input = cube();
        input.holes = Points::Constant(1, 3, 0.5);
        EXPECT_TRUE(says(message_of<SolverFailure>([&] { tetrahedralize(input); }),
                         {"tetgen", "no tetrahedra", "holes"}));
    });
}

TEST_F(MesherTest, without_the_program_it_is_told_how_to_get_it) {
    const Variable path("PATH", "/nowhere");
    EXPECT_FALSE(is_available());
    EXPECT_TRUE(says(message_of<BackendUnavailable>([] { tetrahedralize(cube()); }), missing));
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

TEST_F(MesherTest, a_crash_is_decoded) {
    EXPECT_TRUE(says(failure_of("echo broken; kill -SEGV $$"),
                     {"tetgen", "signal", "Segmentation fault", "broken"}));
    EXPECT_TRUE(says(failure_of("exit 3"), {"tetgen", "exit code 3"}));
}

TEST_F(MesherTest, output_that_is_none_is_refused) {
    const auto wrote = [](const std::string& points, const std::string& cells) {
        return failure_of("echo '" + points + "' > mesh.1.node; echo '" + cells + "' > mesh.1.ele");
    };
    const std::string tetrahedron = "4 3 0 0 0 0 0 0 1 1 0 0 2 0 1 0 3 0 0 1";
    EXPECT_TRUE(says(failure_of("exit 0"), {"tetgen", "no tetrahedra", "plane"}));
    EXPECT_TRUE(says(wrote("", ""), {"tetgen", "mesh.1.node", "missing", "1 bytes"}));
    EXPECT_TRUE(says(wrote("2000000000 3 0 0", ""),
                     {"tetgen", "mesh.1.node", "2000000000 rows", "17 bytes"}));
    EXPECT_TRUE(says(wrote("1 3 2147483647 1 0 0 0 0", ""),
                     {"tetgen", "mesh.1.node", "2147483647 numbers", "row"}));
    EXPECT_TRUE(says(wrote(tetrahedron, "1 4 -1 0 0 1 2 3"),
                     {"tetgen", "mesh.1.ele", "-1 numbers", "row"}));
    EXPECT_TRUE(
        says(wrote("1 3 0 0 0 nan 0 0", ""), {"tetgen", "mesh.1.node", "point 0", "finite"}));
    EXPECT_TRUE(says(wrote(tetrahedron, "1 4 0 0 0 1 2 4"),
                     {"tetgen", "mesh.1.ele", "tetrahedron 0", "corner 4"}));
    EXPECT_TRUE(
        says(wrote(tetrahedron, "1 4 0 0 0 1"), {"tetgen", "mesh.1.ele", "missing", "12 bytes"}));
    EXPECT_TRUE(
        says(wrote(tetrahedron, "1 4 0 0 0 1 2 3 4"), {"tetgen", "mesh.1.ele", "end", "15 bytes"}));
    EXPECT_TRUE(
        says(wrote(tetrahedron, "1 4 0 0 0 1 2 3"), {"tetgen", "mesh.1.face", "No such file"}));
    const std::string face = "; echo '1 1 0 0 1 2 1' > mesh.1.face";
    EXPECT_TRUE(says(failure_of("echo '" + tetrahedron +
                                "' > mesh.1.node; echo '1 4 0 0 0 1 2 3' > "
                                "mesh.1.ele" +
                                face),
                     {"tetgen", "left out", "point 3"}));
}

TEST_F(MesherTest, only_regular_files_that_are_whole_are_read) {
    const auto wrote = [](const std::string& script) {
        return failure_of("echo > mesh.1.ele; " + script);
    };
    EXPECT_TRUE(says(wrote("mkfifo mesh.1.node"), {"tetgen", "mesh.1.node", "regular file"}));
    EXPECT_TRUE(says(wrote("mkdir mesh.1.node"), {"tetgen", "mesh.1.node", "regular file"}));
    EXPECT_TRUE(
        says(wrote("ln -s mesh.1.ele mesh.1.node"), {"tetgen", "mesh.1.node", "symbolic links"}));
    EXPECT_TRUE(says(wrote("true"), {"tetgen", "mesh.1.node", "No such file"}));
    EXPECT_TRUE(says(wrote("printf '1 3 0 0 0 1.2 3.4 5.6' > mesh.1.node"),
                     {"tetgen", "mesh.1.node", "end", "21 bytes"}));
}

TEST_F(MesherTest, a_mesher_of_ones_own_can_be_registered) {
    register_mesher({.name = "mesher-of-test"}, [](const MesherInput& input, const MesherOptions&) {
        MesherOutput corner{input.points, Simplices(1, 4)};
        corner.tetrahedra << 0, 1, 2, 3;
        return corner;
    });
    MesherInput corner;
    corner.points = Points::Identity(4, 3);
    corner.points.row(3).setConstant(1.0);
    EXPECT_EQ(tetrahedralize(corner, {}, "mesher-of-test").points, corner.points);
    EXPECT_EQ(engines().back().kind, EngineKind::mesher);
}

} // namespace
} // namespace polydec::test::in_mesher
