// SPDX-License-Identifier: MIT
//
// The code on docs/boundary.md: essential, natural and mixed conditions, boundary data of duals.
#include <cmath>
#include <iostream>
#include <numbers>
#include <polydec.h>

namespace {

void mixed_poisson() {
    const auto mesh = polydec::discretize(polydec::hexagons(32));
    const polydec::Points facets = polydec::facet_sites(mesh);
    const auto left_or_right = polydec::essential_where(
        facets, [](const auto& x) { return x[0] < 1e-9 || x[0] > 1 - 1e-9; });

    const polydec::PoissonSolver solver({mesh, polydec::Side::dual, 0, left_or_right});
    const polydec::Vector g = facets * polydec::Vector{{1, 2}};         // u left and right
    const polydec::Vector h = 2 * (facets.col(1).array() - 0.5).sign(); // du/dnu
    const polydec::Vector f = polydec::Vector::Zero(mesh.complex().size(2));
    const auto found = solver.solve(
        {polydec::Side::dual, 0, f},
        {.values = g, .derivative_flow = polydec::outward_flow(mesh, polydec::Side::dual, h)});
    const polydec::Vector exact = polydec::dual_sites(mesh) * polydec::Vector{{1, 2}};
    const double error = (found.form.values - exact).cwiseAbs().maxCoeff();
    std::cout << "linear solution " << (error < 1e-11 ? "exact" : "not exact") << '\n';
}

void first_eigenvalues() {
    const auto mesh = polydec::discretize(polydec::grid(32, 32));
    const auto print = [&](const polydec::BoundaryConditions& conditions) {
        const auto modes =
            polydec::spectrum({mesh, polydec::Side::primal, 0, conditions}, {.count = 1});
        constexpr double pi = std::numbers::pi;
        const double value = modes.eigenvalues[0] / (pi * pi);
        std::cout << (std::abs(value) < 1e-10 ? 0 : value) << ' ';
    };
    print({polydec::BoundaryCondition::essential});
    print({polydec::BoundaryCondition::natural});
    print(polydec::essential_where(polydec::cell_centers(mesh, 1),
                                   [](const auto& x) { return x[0] < 1e-9; }));
    std::cout << "= first eigenvalues / pi^2: Dirichlet, Neumann, one side fixed\n";
}

void dual_boundary_data() {
    const auto mesh =
        polydec::discretize(polydec::hexagons(8), {.star = polydec::StarKind::circumcentric});
    const auto& P = mesh.complex();
    const auto f = [](const polydec::Vector& p) { return p[0] + 2 * p[1]; };
    const auto w = polydec::dual_de_rham(mesh, 0, polydec::function_form(f));
    const polydec::Points facets = polydec::cell_centers(mesh, 1);
    const polydec::Vector g = facets * polydec::Vector{{1, 2}};

    const polydec::Vector dw =
        polydec::dual_derivative(P, 0) * w.values + polydec::dual_boundary_derivative(P, 0) * g;
    const auto exact = polydec::dual_de_rham(mesh, 1, polydec::circulation_form([](const auto&) {
                                                 return polydec::Vector{{1, 2}};
                                             }));
    std::cout << "largest error, boundary included: "
              << ((dw - exact.values).cwiseAbs().maxCoeff() < 1e-13 ? "0" : "not 0") << '\n';
}

void zero_boundary_duals() {
    const auto mesh =
        polydec::discretize(polydec::hexagons(8), {.star = polydec::StarKind::circumcentric});
    std::cout << "boundary edges of zero dual length: " << mesh.degenerate().boundary << '\n';
    try {
        polydec::star(mesh, 1).inverse();
        std::cout << "star_1 can be inverted\n";
    } catch (const polydec::InvalidInput& error) {
        std::cout << error.what() << '\n';
    }
}

} // namespace

int main() {
    mixed_poisson();
    first_eigenvalues();
    dual_boundary_data();
    zero_boundary_duals();
}
