// SPDX-License-Identifier: MIT
//
// A rod heated along its length, cold at one end, with heat loss u' + 2 u = 0 at the other: u = x
// (2/3 - x/2).
#include <iostream>
#include <polydec.h>

int main() {
    const auto rod = polydec::discretize(polydec::kuhn(1, 50));
    const auto cold = polydec::essential_where(polydec::facet_sites(rod),
                                               [](const auto& x) { return x[0] < 0.5; });
    const polydec::FormSpace heat(rod, polydec::Side::primal, 0, polydec::robin_elsewhere(cold, 2));
    const polydec::Vector x = rod.points().col(0), ones = polydec::Vector::Ones(x.size());
    const auto u = polydec::PoissonSolver(heat).solve({polydec::Side::primal, 0, ones}).form.values;
    const auto off = u.array() - x.array() * (2 / 3. - x.array() / 2);
    std::cout << "at the end " << u[x.size() - 1]
              << ", exact to 1e-12: " << (off.abs().maxCoeff() < 1e-12 ? "yes" : "no") << '\n';
}
