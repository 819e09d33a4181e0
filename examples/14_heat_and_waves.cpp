// SPDX-License-Identifier: MIT
//
// Heat and waves in 1, 2, 3 and 4 dimensions; only the pictures depend on the dimension. The boxes
// have n! simplices per cube, which merge into intervals, squares, cubes and tesseracts. With
// u = 0 at the walls, the product of sin(pi x_i) cools as exp(-n pi^2 t), and oscillates with
// period 2 / sqrt(n).
#include "examples/plots/svg_plot.h"

#include <cmath>
#include <fstream>
#include <iostream>
#include <numbers>
#include <optional>
#include <polydec.h>

namespace {

constexpr double pi = std::numbers::pi;

/// Pictures for ParaView of functions that are 0 at the walls; none in four dimensions.
class Film {
public:
    Film(const std::string& name, const polydec::Discretization& box) {
        if (box.dimension() <= 3)
            series_.emplace(name + std::to_string(box.dimension()) + "d.pvd", box);
    }

    void add(double time, const polydec::Cochain& u) {
        if (series_)
            series_->add(time, {{"u", u}});
    }

private:
    std::optional<polydec::Series> series_;
};

polydec::SvgSeries run(int n, int cells) {
    const auto box = polydec::discretize(polydec::kuhn(n, cells));
    const polydec::FormSpace space(box, polydec::Side::primal, 0,
                                   {polydec::BoundaryCondition::essential});
    const auto sine = polydec::de_rham(box, 0, polydec::function_form([](const auto& x) {
                                           return (pi * x.array()).sin().prod();
                                       }));
    const auto amplitude = [&](const polydec::Cochain& u) {
        return polydec::inner_product(box, sine, u) / polydec::inner_product(box, sine, sine);
    };

    polydec::Evolution heat({{space, sine.values, 1}}, {},
                            {.integrator = "implicit-midpoint", .steps = {.fixed_step = 0.001}});
    polydec::SvgSeries cooling{"n = " + std::to_string(n), {0}, {1}, polydec::SvgTrace::line};
    Film cooled("heat", box);
    for (int i = 1; i <= 50; ++i) {
        heat.march(0.001 * i);
        if (i % 10 == 0)
            cooled.add(heat.time(), heat.form(0));
        cooling.x.push_back(heat.time());
        cooling.y.push_back(amplitude(heat.form(0)));
    }

    // half a period reverses the sign of the wave
    const double half = 1 / std::sqrt(n), bound = polydec::stable_step(space);
    const double steps = std::ceil(1.1 * half / bound), dt = half / steps;
    polydec::Waves wave(space, sine.values, {.time_step = dt});
    Film swung("waves", box);
    for (int i = 1; i <= steps; ++i) {
        wave.advance();
        if (i % 4 == 0)
            swung.add(wave.time(), wave.form(0));
    }

    std::cout << "n = " << n << ": " << box.input().size(n) << " simplices, "
              << box.complex().size(n) << " cells; rate of cooling "
              << -std::log(cooling.y.back()) / 0.05 / (n * pi * pi)
              << " of the exact one; after half a period " << amplitude(wave.form(0)) << '\n';
    return cooling;
}

} // namespace

int main() {
    polydec::SvgPlot plot{"Cooling in n dimensions",
                          {"time", polydec::Scale::linear},
                          {"amplitude", polydec::Scale::logarithmic}};
    const int cells[] = {64, 32, 16, 8};
    for (const int n : {1, 2, 3, 4})
        plot.series.push_back(run(n, cells[n - 1]));
    std::ofstream("cooling.svg") << polydec::to_svg(plot);
}
