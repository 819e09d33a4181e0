// SPDX-License-Identifier: MIT
//
// Solves Delta u = f on a square of hexagons, with u = sin(pi x) sin(pi y) and u = 0 on the
// boundary. The unknowns are the values of a dual 0-form at the circumcenters of the hexagons.
// Doubling the number of hexagons per row divides the error by four: order 2.
#include <cmath>
#include <iomanip>
#include <iostream>
#include <numbers>
#include <polydec.h>

namespace {

double error(int columns) {
    const auto hexagons = polydec::discretize(polydec::hexagons(columns));
    const polydec::PoissonSolver solver({hexagons, polydec::Side::dual, 0, {}}); // u is given

    constexpr double pi = std::numbers::pi;
    const polydec::Points sites = polydec::dual_sites(hexagons);
    const polydec::Vector exact = (pi * sites.array()).sin().rowwise().prod();
    const auto u = solver.solve({polydec::Side::dual, 0, 2 * pi * pi * exact}).form.values;

    // L2 norm: each value is weighted by the area of its cell
    const polydec::Vector& areas = hexagons.volumes().primal(2);
    return std::sqrt(areas.dot((u - exact).cwiseAbs2()));
}

} // namespace

int main() {
    const double coarse = error(32), fine = error(64);
    std::cout << "errors " << coarse << " and " << fine << ", order " << std::setprecision(2)
              << std::fixed << std::log2(coarse / fine) << '\n';
}
