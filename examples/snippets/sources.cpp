// SPDX-License-Identifier: MIT
//
// The code on docs/sources.md: sources of forms, harmonic parts, magnets, Robin, periodic boxes.
#include <cmath>
#include <iostream>
#include <numbers>
#include <polydec.h>

namespace {

using std::numbers::pi;

void forms_with_sources() {
    const auto mesh = polydec::discretize(polydec::torus(24, 16));
    const polydec::PoissonSolver solver({mesh, polydec::Side::primal, 1});
    const auto f = polydec::de_rham(mesh, 1, polydec::circulation_form([](const auto& x) {
                                        return polydec::Vector{{x[1], -x[0], x[2]}};
                                    }));
    const auto found = solver.solve(f); // u = found.form, delta u = found.flux

    const auto left = polydec::laplacian(mesh, found.form) + found.removed - f;
    const double share = polydec::norm(mesh, found.removed) / polydec::norm(mesh, f);
    std::cout << "harmonic 1-forms: " << solver.harmonic_forms().cols() << ", share of f " << share
              << ", Delta u - f " << (polydec::norm(mesh, left) < 1e-8 ? "= 0" : "not 0") << '\n';
}

void magnet() {
    // a coil around the middle of a box, iron in its core
    const auto mesh = polydec::discretize(polydec::kuhn(3, 8));
    const auto middle = polydec::cell_centroids(mesh, 3);
    polydec::Vector over_mu = polydec::Vector::Ones(middle.rows());
    for (polydec::Index t = 0; t < over_mu.size(); ++t)
        if (std::hypot(middle(t, 0) - 0.5, middle(t, 1) - 0.5) < 0.2)
            over_mu[t] = 1 / 100.0;
    const auto iron = mesh.with_stars(mesh.stars().with(
        2, polydec::material_star(mesh, 2, polydec::CellData::on_cells(over_mu))));
    const auto coil = polydec::de_rham(mesh, 1, polydec::circulation_form([](const auto& x) {
                                           const double a = x[0] - 0.5, b = x[1] - 0.5;
                                           const double r = std::hypot(a, b);
                                           const double j = r > 0.2 && r < 0.35 ? 1 / r : 0;
                                           return polydec::Vector{{-j * b, j * a, 0}};
                                       }));
    const polydec::PoissonSolver solver(
        {iron, polydec::Side::primal, 1, {polydec::BoundaryCondition::essential}});
    const auto [A, removed, report] = polydec::solve_curl_curl(solver, coil);

    const auto B = polydec::d(iron.complex(), A);
    std::cout << "energy of the field " << 0.5 * std::pow(polydec::norm(iron, B), 2)
              << ", work of the current " << 0.5 * polydec::inner_product(iron, A, coil - removed)
              << '\n';
}

void robin() {
    const auto mesh =
        polydec::discretize(polydec::hexagons(32), {.star = polydec::StarKind::circumcentric});
    const auto cooled =
        polydec::robin_elsewhere({polydec::BoundaryCondition::natural}, 2.0); // du/dnu + 2 u = 0
    const polydec::PoissonSolver solver({mesh, polydec::Side::dual, 0, cooled});
    const polydec::Vector f = polydec::Vector::Ones(mesh.complex().size(2));
    const auto u = solver.solve({polydec::Side::dual, 0, f}).form.values;
    // all heat that is made leaves through the boundary of length 4, where du/dnu = -2 u
    std::cout << "from " << u.minCoeff() << " to " << u.maxCoeff() << '\n';
}

void periodic_box() {
    const auto box = polydec::periodic(polydec::grid(32, 32),
                                       {polydec::Vector{{1, 0}}, polydec::Vector{{0, 1}}});
    const auto mesh = polydec::discretize(box);
    const auto modes = polydec::spectrum({mesh, polydec::Side::primal, 0}, {.count = 5});
    std::cout << "first eigenvalue / (4 pi^2) " << modes.eigenvalues[1] / (4 * pi * pi)
              << ", vertices " << mesh.complex().size(0) << '\n';
    const auto wave = polydec::de_rham(mesh, 1, polydec::circulation_form([](const auto& x) {
                                           return polydec::Vector{{0, std::sin(2 * pi * x[0])}};
                                       }));
    const auto u =
        polydec::PoissonSolver({mesh, polydec::Side::primal, 1}).solve(4 * pi * pi * wave).form;
    std::cout << "error " << polydec::norm(mesh, u - wave) / polydec::norm(mesh, wave) << '\n';
}

} // namespace

int main() {
    forms_with_sources();
    magnet();
    robin();
    periodic_box();
}
