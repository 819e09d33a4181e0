// SPDX-License-Identifier: MIT
//
// Delta u = f on a square of hexagons with u = sin(pi x) sin(pi y), u = 0 on the boundary. The
// unknowns are the values of a dual 0-form, which live at the circumcenters of the hexagons. With
// twice as many hexagons to a row the error falls by four: order 2.
#include <cmath>
#include <iomanip>
#include <iostream>
#include <numbers>
#include <polydec.h>

namespace {

double error(int columns) {
    const auto hexagons = polydec::discretize(polydec::hexagons(columns));
    polydec::PoissonSolver solver(hexagons, {.side = polydec::Side::dual});

    constexpr double pi = std::numbers::pi;
    const polydec::Vector x = solver.sites().col(0), y = solver.sites().col(1);
    const polydec::Vector exact = (pi * x.array()).sin() * (pi * y.array()).sin();
    const polydec::Vector zero = polydec::Vector::Zero(solver.boundary_sites().rows());
    const polydec::Vector u = solver.solve(2 * pi * pi * exact, zero).values;

    // L2 norm: each value counts with the area of its cell
    const polydec::Vector& areas = hexagons.volumes().primal(2);
    return std::sqrt(areas.dot((u - exact).cwiseAbs2()));
}

} // namespace

int main() {
    const double coarse = error(32), fine = error(64);
    std::cout << "errors " << coarse << " and " << fine << ", order " << std::setprecision(2)
              << std::fixed << std::log2(coarse / fine) << '\n';
}
