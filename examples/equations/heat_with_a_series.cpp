// SPDX-License-Identifier: MIT
//
// Heat diffuses on a sphere, with pictures for ParaView: the height z decays as exp(-2 t).
#include <iostream>
#include <polydec.h>

int main() {
    const auto sphere = polydec::discretize(polydec::goldberg(8));
    const polydec::Cochain z{polydec::Side::primal, 0, sphere.points().col(2)};
    polydec::Evolution heat(
        {{.space = {sphere, polydec::Side::primal, 0}, .start = z.values, .diffusion = 1}});
    polydec::Series film("heat.pvd", sphere);
    polydec::march(heat, {0.1, 0.2, 0.3, 0.4, 0.5}, {.show = [&](const polydec::Run& now) {
                       film.add(now.time(), {{"heat", now.form(0)}});
                   }});
    const double left = polydec::norm(sphere, heat.form(0)) / polydec::norm(sphere, z);
    std::cout << "after 0.5 there is " << left << " of it\n";
}
