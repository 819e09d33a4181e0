// SPDX-License-Identifier: MIT
//
// Darcy flow from left to right carries salt into a porous rock of hexagons.
#include <iostream>
#include <polydec.h>

int main() {
    const auto rock = polydec::discretize(polydec::hexagons(32));
    const polydec::Points facets = polydec::facet_sites(rock);
    polydec::Vector salt = polydec::Vector::Zero(rock.complex().size(2));
    const auto ends = polydec::essential_where(
        facets, [](const auto& x) { return x[0] < 1e-9 || x[0] > 1 - 1e-9; });
    const polydec::Vector x = facets.col(0), salty = polydec::Vector::Ones(x.size());
    const polydec::PoissonSolver darcy({rock, polydec::Side::dual, 0, ends});
    const auto w = darcy.solve({polydec::Side::dual, 0, salt}, {.values = salty - x}).flux.values;
    const polydec::FluxTransport transport(rock);
    double came = 0, dt = 0.9 * transport.stable_step(w);
    for (double t = 0; t < 0.5; t += dt) {
        came -= dt * transport.outflow(transport.mass_flux(w, salt, salty));
        salt += dt * transport.rate(w, salt, salty);
    }
    std::cout << "salt that came " << came << ", and is there " << transport.mass(salt) << '\n';
}
