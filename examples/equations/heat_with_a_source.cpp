// SPDX-License-Identifier: MIT
//
// Heat with a time-dependent source and cold walls: u = cos t sin(pi x) sin(pi y).
#include <cmath>
#include <iostream>
#include <numbers>
#include <polydec.h>

int main() {
    using std::numbers::pi;
    constexpr auto essential = polydec::BoundaryCondition::essential;
    const auto square = polydec::discretize(polydec::grid(32, 32));
    const auto shape = polydec::de_rham(square, 0, polydec::function_form([](const auto& x) {
                                            return std::sin(pi * x[0]) * std::sin(pi * x[1]);
                                        }));
    const auto source = [&](double t, const auto&) {
        const double amount = 2 * pi * pi * std::cos(t) - std::sin(t);
        return std::vector<polydec::Vector>{amount * shape.values};
    };
    polydec::Evolution heat({{{square, polydec::Side::primal, 0, {essential}}, shape.values, 1}},
                            source);
    heat.march(2);
    const auto error = heat.form(0) - std::cos(2) * shape;
    std::cout << "off by " << polydec::norm(square, error) / polydec::norm(square, shape) << '\n';
}
