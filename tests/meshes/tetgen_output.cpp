// SPDX-License-Identifier: MIT
#include "meshes/tetgen/tetgen_output.h"

#include "meshes/tetgen/tetrahedron_sign.h"
#include "tests/meshes/tetgen_support.h"

namespace polydec::test::in_tetgen_output {

using Spoil = std::function<void(TetgenOutput&)>;

/// What is said of an output, with the points as they are in input units.
std::string verdict_on(const Mesh& surface, TetgenOutput output,
                       const Points& holes = Points(0, 3)) {
    const auto input = tetgen_input(surface, holes);
    output.points *= std::ldexp(1.0, -input.exponent);
    const auto text = message_of<SolverFailure>([&] { check_tetgen_output(input, output); });
    const std::string begin = "tetgen did not return the requested mesh: ";
    return text.substr(0, begin.size()) == begin
               ? text.substr(begin.size(), text.find('\n') - begin.size())
               : text;
}

/// The faces of a cell with their facets, the first triangles of the sides of a cube: those whose
/// corners have one coordinate in common.
void add_faces(TetgenOutput& mesh, const std::array<Index, 4>& cell, Index first, Index facets) {
    for (std::size_t left_out = 0; left_out < 4; ++left_out) {
        std::vector<Index> face;
        for (std::size_t i = 0; i < 4; ++i)
            if (i != left_out)
                face.push_back(cell[i] - first);
        for (int axis = 0; axis < 3; ++axis) {
            const auto side = [&](Index corner) { return corner >> axis & 1; };
            if (side(face[0]) != side(face[1]) || side(face[0]) != side(face[2]))
                continue;
            const Index row = static_cast<Index>(mesh.faces.rows());
            mesh.faces.conservativeResize(row + 1, 3);
            mesh.faces.row(row) << first + face[0], first + face[1], first + face[2];
            const Index order[] = {8, 4, 0}; // of the sides of a cube across x, y, z
            mesh.facets.push_back(facets + order[axis] + 2 * side(face[0]));
        }
    }
}

/// A cube as six tetrahedra around its diagonal, with corners and facets that begin there.
void add_cube(TetgenOutput& mesh, Index first, Index facets) {
    std::array<int, 3> axes{0, 1, 2};
    for (bool even = true;; even = !even) {
        const Index a = 1 << axes[0], b = a | 1 << axes[1];
        std::array<Index, 4> cell{first, first + a, first + b, first + 7};
        // the second and third permutation differ by a swap, and so on: 012 021 102 120 201 210
        const bool is_odd = (axes[0] > axes[1]) != ((axes[0] > axes[2]) != (axes[1] > axes[2]));
        if (is_odd)
            std::swap(cell[2], cell[3]);
        const Index row = static_cast<Index>(mesh.tetrahedra.rows());
        mesh.tetrahedra.conservativeResize(row + 1, 4);
        mesh.tetrahedra.row(row) << cell[0], cell[1], cell[2], cell[3];
        add_faces(mesh, cell, first, facets);
        if (!std::next_permutation(axes.begin(), axes.end()))
            return;
    }
}

TetgenOutput filled_cube() {
    TetgenOutput mesh{cube().points, Simplices(0, 4), Simplices(0, 3)};
    add_cube(mesh, 0, 0);
    return mesh;
}

std::string verdict_on_cube(const Spoil& spoil) {
    auto mesh = filled_cube();
    spoil(mesh);
    return verdict_on(cube(), mesh);
}

void remove_last_cell(TetgenOutput& mesh) {
    mesh.tetrahedra.conservativeResize(mesh.tetrahedra.rows() - 1, 4);
}

TEST(TetgenOutput, a_filled_surface_is_fine_at_every_scale) {
    EXPECT_EQ(verdict_on(cube(), filled_cube()), "accepted");
    for (const double scale : {1e-100, 3.0, 1e100}) {
        auto mesh = filled_cube();
        mesh.points *= scale;
        EXPECT_EQ(verdict_on(cube(scale), mesh), "accepted");
    }
}

TEST(TetgenOutput, every_tetrahedron_has_a_positive_volume) {
    EXPECT_SAYS(verdict_on_cube(
                    [](auto& mesh) { std::swap(mesh.tetrahedra(2, 0), mesh.tetrahedra(2, 1)); }),
                "tetrahedron 2", "inside out");
    EXPECT_SAYS(verdict_on_cube([](auto& mesh) { mesh.tetrahedra.row(3) << 0, 1, 2, 3; }),
                "tetrahedron 3 (0 1 2 3)", "flat");
}

TEST(TetgenOutput, the_sign_of_a_volume_is_exact) {
    const Eigen::Vector3d a(0.1, 0.2, 0.3), b(0.7, 0.1, 0.4), c(0.2, 0.9, 0.8);
    const Eigen::Vector3d within = 0.5 * (b + c); // but for rounding
    for (const double step : {-1.0, 1.0}) {
        const Eigen::Vector3d d = within + step * 1e-16 * (b - a).cross(c - a).normalized();
        EXPECT_EQ(tetrahedron_sign(a, b, c, d), -tetrahedron_sign(a, c, b, d));
        EXPECT_EQ(tetrahedron_sign(a, b, c, d), -tetrahedron_sign(d, b, c, a));
    }
    const Eigen::Vector3d x(1, 0, 0), y(0, 1, 0), tilted(3, 5, std::ldexp(1.0, -1000));
    EXPECT_EQ(tetrahedron_sign({0, 0, 0}, x, y, tilted), 1);
    EXPECT_EQ(tetrahedron_sign({0, 0, 0}, y, x, tilted), -1);
    EXPECT_EQ(tetrahedron_sign({0, 0, 0}, x, y, {3, 5, 0}), 0);
}

TEST(TetgenOutput, numbers_exist) {
    const Words message{"no tetrahedra", "points", "facets"};
    for (const Spoil& spoil : {Spoil([](auto& mesh) { mesh.tetrahedra(0, 0) = 8; }),
                               Spoil([](auto& mesh) { mesh.tetrahedra(0, 0) = -1; }),
                               Spoil([](auto& mesh) { mesh.tetrahedra.resize(0, 4); }),
                               Spoil([](auto& mesh) { mesh.faces(0, 0) = 8; }),
                               Spoil([](auto& mesh) { mesh.facets[0] = 12; }),
                               Spoil([](auto& mesh) { mesh.facets.pop_back(); }),
                               Spoil([](auto& mesh) { mesh.points(7, 2) = std::nan(""); })})
        EXPECT_TRUE(says(verdict_on_cube(spoil), message));
}

TEST(TetgenOutput, points_stay_where_they_are) {
    EXPECT_SAYS(verdict_on_cube([](auto& mesh) { mesh.points(7, 2) += 1e-15; }), "tetgen",
                "left out", "point 7", "(1, 1, 1)");
}

TEST(TetgenOutput, nothing_is_covered_twice) {
    EXPECT_SAYS(verdict_on_cube([](auto& mesh) {
                    mesh.tetrahedra.conservativeResize(7, 4);
                    mesh.tetrahedra.row(6) = mesh.tetrahedra.row(0);
                }),
                "tetrahedron 0 (0 1 3 7)", "tetrahedron");
}

TEST(TetgenOutput, all_is_filled_up_to_the_facets) {
    EXPECT_SAYS(verdict_on_cube(remove_last_cell), "facet 2 (4 5 7)", "empty");
    EXPECT_SAYS(verdict_on_cube([](auto& mesh) {
                    mesh.points.conservativeResize(9, 3);
                    mesh.points.row(8) << 0.5, 0.5, 2.0;
                    mesh.tetrahedra.conservativeResize(7, 4);
                    mesh.tetrahedra.row(6) << 4, 5, 7, 8;
                }),
                "faces", "boundary", "no facet");
}

TEST(TetgenOutput, facets_are_unions_of_faces) {
    EXPECT_SAYS(verdict_on_cube([](auto& mesh) { mesh.facets[0] = mesh.facets[0] == 0 ? 2 : 0; }),
                "point", "facet", "plane");
    EXPECT_SAYS(verdict_on_cube([](auto& mesh) {
                    mesh.faces.conservativeResize(11, 3);
                    mesh.facets.resize(11);
                }),
                "facets", "close", "point");
}

TEST(TetgenOutput, holes_and_only_holes_are_empty) {
    const Points hole = Points::Constant(1, 3, 0.5);
    EXPECT_SAYS(verdict_on(cube(), filled_cube(), hole), "inside", "facet");
    EXPECT_EQ(verdict_on(cube(), filled_cube()), "accepted");
}

TEST(TetgenOutput, parts_beside_each_other_are_all_filled) {
    const auto input = united(cube(), cube(1.0, 3.0));
    TetgenOutput mesh{input.points, Simplices(0, 4), Simplices(0, 3)};
    add_cube(mesh, 0, 0);
    const auto half = mesh;
    add_cube(mesh, 8, 12);
    EXPECT_EQ(verdict_on(input, mesh), "accepted");
    EXPECT_SAYS(verdict_on(input, half), "facet 12 (8 10 11)", "covered", "0");
    mesh.tetrahedra = half.tetrahedra;
    EXPECT_SAYS(verdict_on(input, mesh), "inside", "facet");
}

} // namespace polydec::test::in_tetgen_output
