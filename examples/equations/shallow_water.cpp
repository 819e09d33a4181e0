// SPDX-License-Identifier: MIT
//
// A hill of water travels around a rotating planet. Mass and energy are conserved.
#include <cmath>
#include <iostream>
#include <polydec.h>

int main() {
    const auto planet = polydec::discretize(polydec::goldberg(8));
    const polydec::ShallowWater water(planet, {.rotation = 2 * planet.points().col(2)});
    const auto depth = polydec::dual_de_rham(planet, 0, polydec::function_form([](const auto& x) {
                                                 return 1 + 0.2 * std::exp(8 * (x[0] - 1));
                                             }));
    const polydec::ShallowWater::State start{depth.values, polydec::Vector::Zero(planet.size(1))};
    polydec::Evolution run({{{planet, polydec::Side::dual, 0}, start.depth},
                            {{planet, polydec::Side::primal, 1}, start.flux}},
                           water, {.steps = {.relative_tolerance = 1e-8}});
    run.march(5);
    const polydec::ShallowWater::State now{run.forms()[0].values, run.forms()[1].values};
    std::cout << "highest " << now.depth.maxCoeff() << ", of the mass is kept "
              << water.mass(now) / water.mass(start) << ", of the energy "
              << water.energy(now) / water.energy(start) << '\n';
}
