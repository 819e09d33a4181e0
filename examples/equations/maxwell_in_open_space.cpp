// SPDX-License-Identifier: MIT
//
// Maxwell's equations: a ring of current in the middle of a box flashes, and a layer of five cubes
// along its sides swallows what comes.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <polydec.h>

int main() {
    const auto box = polydec::discretize(polydec::kuhn(3, 20));
    const auto ring = polydec::de_rham(box, 1, polydec::circulation_form([](const auto& x) {
                                           const polydec::Vector r = x.array() - 0.5;
                                           const double near = std::exp(-60 * r.squaredNorm());
                                           return polydec::Vector{{-r[1] * near, r[0] * near, 0}};
                                       }));
    const polydec::Leapfrog light(box, {}, polydec::Side::primal, 1,
                                  {.time_step = 0.025, .layer = {.width = 0.25}});
    polydec::WaveState now{0 * ring.values, polydec::Vector::Zero(box.complex().size(2))};
    double most = 0;
    for (double t = 0.0125; t < 3; t += light.time_step()) {
        light.step(now, {(t - 0.5) * std::exp(-50 * std::pow(t - 0.5, 2)) * ring.values});
        most = std::max(most, light.energy(now.E, now.B));
    }
    std::cout << "of the energy stays " << light.energy(now.E, now.B) / most << '\n';
}
