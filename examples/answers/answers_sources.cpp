// SPDX-License-Identifier: MIT
//
// The C++ code of docs/answers about sources and spectra: prints each answer behind its name.
#include "examples/answers/answers.h"

#include <cmath>
#include <iostream>
#include <numbers>
#include <polydec.h>

namespace {

using polydec::BoundaryCondition;
using polydec::Side;

void poisson_on_named_group() {
    const auto plate = polydec::discretize(polydec::read_mesh("plate.msh"),
                                           {.materials = polydec::Materials::keep_apart});
    const auto hot = polydec::facets_in(plate, {"hot"}), cold = polydec::facets_in(plate, {"cold"});
    const polydec::FormSpace space(
        plate, Side::primal, 0,
        polydec::BoundaryConditions(BoundaryCondition::natural).essential(hot).essential(cold));
    const auto data = polydec::boundary_data(space, {{hot, 100}, {cold, 20}});
    const polydec::Vector f = polydec::Vector::Zero(plate.size(0));
    const auto u = polydec::PoissonSolver(space).solve({Side::primal, 0, f}, data).form.values;
    std::cout << "in the middle: " << u.mean() << '\n';
}

void given_flux() {
    const auto square = polydec::discretize(polydec::grid(16, 16));
    const polydec::Points at = polydec::facet_sites(square);
    const auto left = polydec::essential_where(at, [](const auto& x) { return x[0] < 1e-9; });
    const polydec::Vector inflow = 3 * (at.col(0).array() > 1 - 1e-9).cast<double>();
    const auto data = polydec::outward_flow(square, Side::primal, inflow);
    const polydec::PoissonSolver solver({square, Side::primal, 0, left});
    const polydec::Vector f = polydec::Vector::Zero(square.size(0));
    const auto u = solver.solve({Side::primal, 0, f}, {.derivative_flow = data}).form.values;
    std::cout << "largest value: " << u.maxCoeff() << '\n'; // u = 3 x
}

void robin_condition() {
    const auto square = polydec::discretize(polydec::grid(16, 16));
    const auto cold = polydec::essential_where(polydec::facet_sites(square),
                                               [](const auto& x) { return x[0] < 1e-9; });
    const polydec::PoissonSolver solver(
        {square, Side::primal, 0, polydec::robin_elsewhere(cold, 2)});
    const polydec::Vector f = polydec::Vector::Ones(square.size(0));
    const auto u = solver.solve({Side::primal, 0, f}).form.values;
    std::cout << "largest value: " << u.maxCoeff() << '\n';
}

void darcy_flow() {
    const auto plate = polydec::discretize(polydec::read_mesh("plate.msh"),
                                           {.materials = polydec::Materials::keep_apart});
    polydec::Vector kappa(plate.size(2));
    for (polydec::Index c = 0; c < kappa.size(); ++c)
        kappa[c] = plate.tags()[c] == 4 ? 10 : 1;
    const auto on_cells = polydec::CellData::on_cells(kappa);
    const auto rock = polydec::with_conductivity(plate, Side::dual, on_cells);
    const auto ends = polydec::essential_on(rock, {"hot", "cold"});
    const polydec::PoissonSolver solver({rock, Side::dual, 0, ends});
    const auto x = polydec::facet_sites(rock).col(0).array().eval();
    const auto w = solver.solve({Side::dual, 0, 0 * kappa}, {.values = 1 - x}).flux.values;
    std::cout << "through the right side: " << (x > 1 - 1e-9).select(w.cwiseAbs(), 0).sum() << '\n';
}

void magnetic_coil() {
    const auto box = polydec::discretize(polydec::kuhn(3, 8));
    const polydec::Points at = polydec::cell_centroids(box, 3).array() - 0.5;
    const auto r = at.leftCols(2).rowwise().norm().array();
    const auto over_mu = polydec::CellData::on_cells((r < 0.2).select(0.01, 0 * r + 1));
    const auto iron = polydec::with_material(box, 2, over_mu);
    const auto coil = polydec::de_rham(box, 1, polydec::circulation_form([](const auto& x) {
                                           return polydec::Vector{{0.5 - x[1], x[0] - 0.5, 0}};
                                       }));
    const polydec::PoissonSolver solver({iron, Side::primal, 1, {BoundaryCondition::essential}});
    const auto A = polydec::solve_curl_curl(solver, coil).potential;
    const double norm = polydec::norm(iron, polydec::d(iron.complex(), A));
    std::cout << "energy " << norm * norm / 2 << ", work "
              << polydec::inner_product(iron, A, coil) / 2 << '\n';
}

void error_of_solution() {
    const auto square =
        polydec::discretize(polydec::grid(32, 32), {.criterion = polydec::MergeCriterion::none});
    const polydec::Vector f = polydec::Vector::Ones(square.size(0));
    const polydec::PoissonSolver solver({square, Side::primal, 0, {}});
    const auto u = solver.solve({Side::primal, 0, f}).form.values;
    const auto problem = polydec::poisson_problem(square, {}, {}, f, {});
    const auto error = polydec::poisson_error(problem, u);
    std::cout << "gradient off by at most " << 100 * error.energy / error.size << " %\n";
    const auto goal = polydec::goal_interval(problem, u, problem.source);
    std::cout << "the integral of u lies between " << goal.lower << " and " << goal.upper << '\n';
}

void modes_of_part() {
    polydec::write_mesh("part.stl", polydec::flange(48)); // or your own file
    const auto part = polydec::discretize(polydec::read_mesh("part.stl"));
    const auto modes = polydec::spectrum({part, Side::primal, 0}, {.count = 4});
    std::cout << "eigenvalues: " << modes.eigenvalues.tail(3).transpose() << '\n';
    std::cout << "none is missing: " << (modes.certificate.complete ? "proved" : "not proved")
              << '\n';
    polydec::write_page("modes.html", polydec::draw_page(part, modes));
}

void maxwell_cavity_modes() {
    const auto box = polydec::discretize(polydec::kuhn(3, 8));
    const polydec::FormSpace cavity(box, Side::primal, 1,
                                    {BoundaryCondition::essential}); // E is normal to the walls
    const auto modes = polydec::coexact_spectrum(cavity, {.count = 5});
    std::cout << "over pi^2:"; // 2 2 2 3 3
    for (const double value : modes.eigenvalues)
        std::cout << ' ' << value / (std::numbers::pi * std::numbers::pi);
    std::cout << '\n';
}

void exactness_of_eigenvalue() {
    const auto square = polydec::discretize(polydec::grid(16, 16));
    const auto discrete = polydec::spectrum({square, Side::dual, 0}, {.count = 1}); // of the mesh
    std::cout << "mesh " << discrete.eigenvalues[0]
              << ", radius below 1e-9: " << (discrete.radii[0] < 1e-9 ? "yes" : "no") << '\n';
    const auto triangles =
        polydec::discretize(polydec::grid(16, 16), {.criterion = polydec::MergeCriterion::none});
    const auto shape = polydec::shape_of(triangles, {BoundaryCondition::essential});
    const auto found = polydec::shape_spectrum(shape, {.count = 1}); // 2 pi^2 = 19.7392
    std::cout << "shape between " << found.lower[0] << " and " << found.upper[0] << '\n';
}

void eigenvalues_of_own_matrices() {
    polydec::SparseMatrix A(100, 100);
    for (polydec::Index i = 0; i < 100; ++i) {
        A.insert(i, i) = 2;
        if (i > 0)
            A.insert(i, i - 1) = A.insert(i - 1, i) = -1;
    }
    const polydec::Vector M = polydec::Vector::Ones(100);
    const auto found = polydec::CertifiedEigensolver(A, M).smallest(3);
    std::cout << "eigenvalues: " << found.values.transpose() << '\n';
    std::cout << "none is missing: " << (found.certificate.complete ? "proved" : "not proved")
              << '\n';
}

void betti_numbers() {
    const auto torus = polydec::discretize(polydec::torus(32, 16));
    std::cout << "Betti numbers:";
    for (const auto b : polydec::betti_numbers(torus.complex()))
        std::cout << ' ' << b;
    const polydec::SparseMatrix loops = polydec::homology_generators(torus.complex(), 1);
    const polydec::Vector edges = loops.cwiseAbs().transpose() * polydec::Vector::Ones(1024);
    std::cout << "\nedges of the loops: " << edges.minCoeff() << ' ' << edges.maxCoeff() << '\n';
}

void four_dimensions() {
    const auto box = polydec::discretize(polydec::kuhn(4, 3)); // 24 * 81 simplices
    std::cout << "cells of each degree:";
    for (int k = 0; k <= 4; ++k)
        std::cout << ' ' << box.size(k);
    const auto modes = polydec::spectrum({box, Side::dual, 0}, {.count = 1});
    std::cout << "\nfirst eigenvalue over 4 pi^2: "
              << modes.eigenvalues[0] / (4 * std::numbers::pi * std::numbers::pi) << '\n';
}

} // namespace

int main() {
    return answers::print({{"poisson_on_named_group", poisson_on_named_group},
                           {"given_flux", given_flux},
                           {"robin_condition", robin_condition},
                           {"darcy_flow", darcy_flow},
                           {"magnetic_coil", magnetic_coil},
                           {"error_of_solution", error_of_solution},
                           {"modes_of_part", modes_of_part},
                           {"maxwell_cavity_modes", maxwell_cavity_modes},
                           {"exactness_of_eigenvalue", exactness_of_eigenvalue},
                           {"eigenvalues_of_own_matrices", eigenvalues_of_own_matrices},
                           {"betti_numbers", betti_numbers},
                           {"four_dimensions", four_dimensions}});
}
