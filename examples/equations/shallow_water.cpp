// SPDX-License-Identifier: MIT
//
// A hill of water travels around a rotating planet. Mass and energy are conserved.
#include <cmath>
#include <iostream>
#include <polydec.h>

int main() {
    const auto planet = polydec::discretize(polydec::goldberg(8));
    const polydec::Vector rotation = 2 * planet.points().col(2);
    const polydec::ShallowWater water(planet, {.gravity = 1, .rotation = rotation});
    const auto depth = polydec::dual_de_rham(planet, 0, polydec::function_form([](const auto& x) {
                                                 return 1 + 0.2 * std::exp(8 * (x[0] - 1));
                                             }));
    polydec::ShallowWater::State now{depth.values, polydec::Vector::Zero(planet.complex().size(1))};
    const double mass = water.mass(now), energy = water.energy(now);
    const double dt = 0.5 * water.stable_step(now);
    for (int i = 0; i < 200; ++i)
        now = water.step(now, dt);
    std::cout << "highest " << now.depth.maxCoeff() << ", of the mass is kept "
              << water.mass(now) / mass << ", of the energy " << water.energy(now) / energy << '\n';
}
