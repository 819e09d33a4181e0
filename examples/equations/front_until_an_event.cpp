// SPDX-License-Identifier: MIT
//
// A front of u' = u_xx + u (1 - u) (u - 0.1) advances until it reaches the middle: at time 17.678,
// with speed 0.8 / sqrt(2).
#include <cmath>
#include <iostream>
#include <polydec.h>

int main() {
    const auto line = polydec::discretize(polydec::kuhn(std::vector{400}, {40.0}));
    const auto front = polydec::de_rham(line, 0, polydec::function_form([](const auto& x) {
                                            return 1 / (1 + std::exp((x[0] - 10) / std::sqrt(2)));
                                        }));
    const auto reaction = [](double, const std::vector<polydec::Cochain>& now) {
        const auto u = now[0].values.array();
        return std::vector<polydec::Vector>{u * (1 - u) * (u - 0.1)};
    };
    const auto in_the_middle = [](double, const auto& now) { return now[0].values[200] - 0.5; };
    polydec::Evolution fire(
        {{.space = {line, polydec::Side::primal, 0}, .start = front.values, .diffusion = 1}},
        reaction, {.event = in_the_middle});
    fire.march(100);
    std::cout << "in the middle at " << fire.time() << '\n';
}
