// SPDX-License-Identifier: MIT
//
// Dividing spots: the Gray-Scott reaction of two substances on a sphere of hexagons.
#include <iostream>
#include <polydec.h>

int main() {
    const auto sphere = polydec::discretize(polydec::goldberg(10));
    const auto x = (8 * sphere.points().array()).sin();
    const polydec::Vector seeds = (x.col(0) * x.col(1) * x.col(2) > 0.3).cast<double>();
    const polydec::Vector u = 1 - seeds.array() / 2, v = seeds / 4;
    const auto reaction = [](double, const std::vector<polydec::Cochain>& now) {
        const auto a = now[0].values.array(), b = now[1].values.array();
        return std::vector<polydec::Vector>{0.037 * (1 - a) - a * b * b, a * b * b - 0.1 * b};
    };
    polydec::Evolution pattern({{{sphere, polydec::Side::primal, 0}, u, 6e-4},
                                {{sphere, polydec::Side::primal, 0}, v, 3e-4}},
                               reaction);
    pattern.march(1000);
    const auto [fed, grown] = std::pair(pattern.form(0).values, pattern.form(1).values);
    std::cout << "food from " << fed.minCoeff() << " to " << fed.maxCoeff() << ", spots up to "
              << grown.maxCoeff() << '\n';
}
