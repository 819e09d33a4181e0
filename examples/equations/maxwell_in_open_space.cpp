// SPDX-License-Identifier: MIT
//
// Maxwell's equations: a ring of current flashes in the middle of a box, and a layer of five cubes
// along the sides absorbs the waves.
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
    polydec::WaveOptions open{.time_step = 0.025, .layer = polydec::AbsorbingLayer{box, 0.25}};
    open.source = [&](double t) -> polydec::Vector {
        return (t - 0.5) * std::exp(-50 * std::pow(t - 0.5, 2)) * ring.values;
    };
    polydec::Waves light({box, polydec::Side::primal, 1, {polydec::BoundaryCondition::essential}},
                         0 * ring.values, open);
    double most = 0;
    light.march(3, [&](double) { most = std::max(most, light.energy()); });
    std::cout << "of the energy stays " << light.energy() / most << '\n';
}
