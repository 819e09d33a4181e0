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
    polydec::Vector flux = polydec::Vector::Zero(planet.size(1));
    const double mass = water.mass({depth.values, flux}),
                 energy = water.energy({depth.values, flux});
    polydec::Evolution run({{{planet, polydec::Side::dual, 0}, depth.values},
                            {{planet, polydec::Side::primal, 1}, flux}},
                           water, {.steps = {.relative_tolerance = 1e-8}});
    run.march(5);
    const polydec::ShallowWater::State now{run.forms()[0].values, run.forms()[1].values};
    std::cout << "highest " << now.depth.maxCoeff() << ", of the mass is kept "
              << water.mass(now) / mass << ", of the energy " << water.energy(now) / energy << '\n';
}
