// SPDX-License-Identifier: MIT
#include <cmath>
#include <iostream>
#include <numbers>
#include <polydec.h>

int main() {
    constexpr double pi = std::numbers::pi;
    // of dual 0-forms: a value in each square, 0 on the boundary by itself
    const auto drum = polydec::discretize(polydec::grid(32, 32));
    const auto conditions = polydec::built_in_conditions(polydec::Side::dual);
    const auto sine = polydec::function_form(
        [](const auto& x) { return std::sin(pi * x[0]) * std::sin(pi * x[1]); });
    const auto start = polydec::dual_de_rham(drum, 0, sine);
    const double half_period = 1 / std::sqrt(2), dt = half_period / 50;
    const polydec::Leapfrog waves(drum, conditions, start.side, 0, {.time_step = dt});
    polydec::WaveState state{start.values, dt / 2 * polydec::d(drum.complex(), start).values};
    for (int i = 0; i < 50; ++i)
        waves.step(state);
    std::cout << "after half a period " << state.E.dot(start.values) / start.values.squaredNorm()
              << '\n';
}
