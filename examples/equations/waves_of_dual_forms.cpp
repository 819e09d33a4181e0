// SPDX-License-Identifier: MIT
//
// Waves with one value per hexagon of a sphere: z oscillates as cos(sqrt(2) t).
#include <cmath>
#include <iostream>
#include <numbers>
#include <polydec.h>

int main() {
    const auto sphere = polydec::discretize(polydec::goldberg(8));
    const auto z = polydec::dual_de_rham(
        sphere, 0, polydec::function_form([](const auto& x) { return x[2]; }));
    const double half = std::numbers::pi / std::sqrt(2);
    polydec::Waves waves({sphere, polydec::Side::dual, 0}, z.values, {.time_step = half / 50});
    const double before = waves.energy();
    waves.march(half);
    const double after = waves.energy() / before;
    std::cout << "after half a period "
              << waves.form(0).values.dot(z.values) / z.values.squaredNorm()
              << ", energy kept to 1e-12: " << (std::abs(after - 1) < 1e-12 ? "yes" : "no") << '\n';
}
