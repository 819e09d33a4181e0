// SPDX-License-Identifier: MIT
//
// The field of a coil around an iron core in a box. Its energy is the work of the current.
#include <cmath>
#include <iostream>
#include <polydec.h>

int main() {
    const auto box = polydec::discretize(polydec::kuhn(3, 10));
    const polydec::Points at = polydec::cell_centroids(box, 3).array() - 0.5;
    const auto r = at.leftCols(2).rowwise().norm().array();
    const auto over_mu = polydec::CellData::on_cells((r < 0.2).select(0.01, 0 * r + 1));
    const auto iron = box.with_stars(polydec::weighted_stars(box, 2, over_mu));
    const auto coil = polydec::de_rham(box, 1, polydec::circulation_form([](const auto& x) {
                                           const double a = x[0] - 0.5, b = x[1] - 0.5;
                                           const double j = std::exp(-30 * (a * a + b * b));
                                           return polydec::Vector{{-b * j, a * j, 0}};
                                       }));
    const polydec::PoissonSolver solver(
        {iron, polydec::Side::primal, 1, {polydec::BoundaryCondition::essential}});
    const auto [A, removed, report] = polydec::solve_curl_curl(solver, coil);
    std::cout << "energy " << std::pow(polydec::norm(iron, polydec::d(iron.complex(), A)), 2) / 2
              << ", work " << polydec::inner_product(iron, A, coil) / 2 << '\n';
}
