// SPDX-License-Identifier: MIT
//
// The C++ code of docs/answers about meshes and stars: prints each answer behind its name.
#include "examples/answers/answers.h"

#include <fstream>
#include <iostream>
#include <numbers>
#include <polydec.h>

namespace {

using polydec::Side;

void mesh_from_arrays() {
    polydec::Mesh square;
    square.points = polydec::Points{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    square.simplices = polydec::Simplices{{0, 1, 2}, {0, 2, 3}};
    const auto mesh = polydec::discretize(square);
    std::cout << "vertices, edges, cells: " << mesh.size(0) << ' ' << mesh.size(1) << ' '
              << mesh.size(2) << '\n';
    std::cout << "area: " << mesh.volumes().primal(2).sum() << '\n';
}

void quads_or_tetrahedra() {
    polydec::PolygonMesh quads;
    quads.points =
        polydec::Points{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
    quads.corners = {0, 1, 4, 3, 1, 2, 5, 4};
    quads.offsets = {0, 4, 8}; // where each one begins, and the end
    const auto mesh = polydec::discretize(polydec::split_polygons(quads));
    std::cout << "vertices, edges, cells: " << mesh.size(0) << ' ' << mesh.size(1) << ' '
              << mesh.size(2) << '\n';
}

void vertices_at_one_place() {
    const auto box = polydec::read_mesh("box.off"); // six squares, each with corners of its own
    const auto apart = polydec::unjoined_boundary(box);
    std::cout << apart.coincident.size() << " vertices coincide with others\n";
    for (const auto& mesh : {box, polydec::weld(box).mesh}) {
        std::cout << "Betti numbers:";
        for (const auto b : polydec::betti_numbers(polydec::discretize(mesh).complex()))
            std::cout << ' ' << b;
        std::cout << '\n';
    }
}

void hanging_nodes() {
    const auto coarse_and_fine = polydec::read_mesh("hanging.off");
    for (const auto& mesh : {coarse_and_fine, polydec::join_hanging(coarse_and_fine).mesh}) {
        const auto complex = polydec::discretize(mesh);
        const auto modes = polydec::spectrum({complex, Side::primal, 0}, {.count = 2});
        std::cout << "loops " << polydec::betti_numbers(complex.complex())[1]
                  << ", first eigenvalue " << modes.eigenvalues[1] << '\n';
    }
}

void negative_duals() {
    constexpr auto circumcentric = polydec::StarKind::circumcentric;
    const auto rough = polydec::perturbed(polydec::torus(20, 10), 0.05, 1);
    const auto mesh = polydec::discretize(rough, {.star = circumcentric});
    std::cout << "negative dual edges: " << polydec::star(mesh, 1).negatives().size() << '\n';
    const auto flipped =
        polydec::discretize(rough, {.delaunay = polydec::Delaunay::flips, .star = circumcentric});
    std::cout << "after flips: " << polydec::star(flipped, 1).negatives().size() << '\n';
}

void which_star() {
    const auto rough = polydec::perturbed(polydec::torus(20, 10), 0.05, 1);
    const auto mesh = polydec::discretize(rough); // .star = polydec::StarKind::automatic
    std::cout << "stars: " << polydec::name(mesh.chosen_stars().kind) << '\n';
    const auto modes = polydec::spectrum({mesh, Side::primal, 1}, {.count = 4});
    std::cout << "negative eigenvalues: " << (modes.eigenvalues.array() < -1e-9).count() << '\n';
}

void what_works_here() {
    using polydec::MergeCriterion;
    for (const auto criterion : {MergeCriterion::none, MergeCriterion::dual_length}) {
        const auto mesh =
            polydec::discretize(polydec::torus(32, 16),
                                {.criterion = criterion, .star = polydec::StarKind::circumcentric});
        std::cout << "cells " << mesh.size(2) << ", edges with zero dual "
                  << polydec::star(mesh, 1).zeros().size() << '\n';
    }
}

void tetrahedra_from_surface() {
    const auto mesh = polydec::tetrahedralize(polydec::icosphere(4), {.quality = 1.4});
    const auto ball = polydec::discretize(mesh);
    std::cout << "Betti numbers:";
    for (const auto b : polydec::betti_numbers(ball.complex()))
        std::cout << ' ' << b;
    std::cout << "\nvolume " << ball.volumes().primal(3).sum() << '\n';
}

void own_cells() {
    const polydec::IncidenceMatrix d0 =
        Eigen::Matrix<std::int8_t, 3, 3>{{-1, 1, 0}, {0, -1, 1}, {1, 0, -1}}.sparseView();
    const polydec::Vector ones = polydec::Vector::Ones(3), twos = 2 * ones;
    const polydec::Cells ring(polydec::CellComplex({d0}),
                              polydec::CellVolumes({ones, twos}, {twos, ones}));
    std::cout << "Betti numbers:";
    for (const auto b : polydec::betti_numbers(ring.complex()))
        std::cout << ' ' << b;
    const auto modes = polydec::spectrum({ring, Side::primal, 0}, {.count = 3});
    std::cout << "\nlargest eigenvalue: " << modes.eigenvalues[2] << '\n';
}

void box_without_boundary() {
    const auto box = polydec::periodic(polydec::grid(32, 32),
                                       {polydec::Vector{{1, 0}}, polydec::Vector{{0, 1}}});
    const auto mesh = polydec::discretize(box);
    const auto modes = polydec::spectrum({mesh, Side::primal, 0}, {.count = 2});
    std::cout << "Betti numbers:";
    for (const auto b : polydec::betti_numbers(mesh.complex()))
        std::cout << ' ' << b;
    std::cout << "\nfirst eigenvalue over 4 pi^2: "
              << modes.eigenvalues[1] / (4 * std::numbers::pi * std::numbers::pi) << '\n';
}

void draw_duals() {
    const auto hexagons = polydec::discretize(polydec::hexagons(3));
    std::ofstream("hexagons.svg") << polydec::to_svg(
        polydec::draw_structure(hexagons, {.duals = true, .numbers = true, .orientations = true}));
    std::cout << "cells: " << hexagons.size(2) << '\n';
}

} // namespace

int main() {
    return answers::print({{"mesh_from_arrays", mesh_from_arrays},
                           {"quads_or_tetrahedra", quads_or_tetrahedra},
                           {"vertices_at_one_place", vertices_at_one_place},
                           {"hanging_nodes", hanging_nodes},
                           {"negative_duals", negative_duals},
                           {"which_star", which_star},
                           {"what_works_here", what_works_here},
                           {"tetrahedra_from_surface", tetrahedra_from_surface},
                           {"own_cells", own_cells},
                           {"box_without_boundary", box_without_boundary},
                           {"draw_duals", draw_duals}});
}
