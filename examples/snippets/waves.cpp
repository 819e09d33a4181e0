// SPDX-License-Identifier: MIT
#include <cmath>
#include <iostream>
#include <numbers>
#include <polydec.h>

int main() {
    constexpr double pi = std::numbers::pi;
    // of dual 0-forms: a value in each square, 0 on the boundary by itself
    const auto drum = polydec::discretize(polydec::grid(32, 32));
    const auto sine = polydec::function_form(
        [](const auto& x) { return std::sin(pi * x[0]) * std::sin(pi * x[1]); });
    const auto start = polydec::dual_de_rham(drum, 0, sine);
    const double half_period = 1 / std::sqrt(2);
    polydec::Waves waves({drum, polydec::Side::dual, 0}, start.values,
                         {.time_step = half_period / 50});
    waves.march(half_period);
    std::cout << "after half a period "
              << waves.form(0).values.dot(start.values) / start.values.squaredNorm() << '\n';
}
