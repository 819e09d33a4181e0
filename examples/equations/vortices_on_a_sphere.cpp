// SPDX-License-Identifier: MIT
//
// Two vortices on a sphere of hexagons orbit each other. Without viscosity, energy is conserved.
#include <cmath>
#include <iostream>
#include <polydec.h>

int main() {
    const auto sphere = polydec::discretize(polydec::goldberg(8));
    const auto vorticity = polydec::de_rham(sphere, 0, polydec::function_form([](const auto& x) {
                                                const double z = 8 * x[2] * x[2];
                                                return std::exp(-8 * std::pow(x[1] - 0.4, 2) - z) -
                                                       std::exp(-8 * std::pow(x[1] + 0.4, 2) - z);
                                            }));
    const polydec::IncompressibleFlow flow(sphere);
    const auto start = flow.project(polydec::flow_of_vorticity(sphere, vorticity.values));
    const double before = flow.energy(start);
    polydec::Flow vortices(flow, start, {.time_step = 0.5 * flow.exchange_time(start)});
    vortices.advance(100);
    std::cout << "energy " << before << ", kept to 1e-10: "
              << (std::abs(flow.energy(vortices.flux()) / before - 1) < 1e-10 ? "yes" : "no")
              << '\n';
}
