// SPDX-License-Identifier: MIT
//
// Heat and waves in 1, 2, 3 and 4 dimensions: only the pictures have to know which. The boxes are
// of n! simplices a cube, which merge into intervals, squares, cubes and tesseracts. With u = 0 at
// the walls the product of sin(pi x_i) cools as exp(-n pi^2 t), and swings with the period 2 /
// sqrt(n).
#include "examples/plots/svg_plot.h"

#include <cmath>
#include <fstream>
#include <iostream>
#include <numbers>
#include <optional>
#include <polydec.h>

namespace {

constexpr double pi = std::numbers::pi;

/// Pictures of functions that are 0 at the walls, for ParaView; none of four dimensions.
class Film {
public:
    Film(const std::string& name, const polydec::Discretization& box,
         const polydec::RelativeComplex& inside)
        : inside_(inside) {
        if (box.dimension() <= 3)
            series_.emplace(name + std::to_string(box.dimension()) + "d.pvd", box);
    }

    void add(double time, const polydec::Vector& u) {
        if (series_)
            series_->add(time, {{"u", {polydec::Side::primal, 0, inside_.extend(0, u)}}});
    }

private:
    const polydec::RelativeComplex& inside_;
    std::optional<polydec::Series> series_;
};

polydec::SvgSeries run(int n, int cells) {
    const auto box = polydec::discretize(polydec::kuhn(n, cells));
    const auto inside = polydec::relative_to_boundary(box.complex());
    const auto volumes = polydec::relative_volumes(inside, box.volumes());
    const auto sine = polydec::de_rham(box, 0, polydec::function_form([](const auto& x) {
                                           return (pi * x.array()).sin().prod();
                                       }));
    const polydec::Cochain start{polydec::Side::primal, 0, inside.restrict(0, sine.values)};
    const auto amplitude = [&](const polydec::Cochain& u) {
        return polydec::inner_product({inside.complex, volumes}, start, u) /
               polydec::inner_product({inside.complex, volumes}, start, start);
    };

    polydec::HeatSolver heat({inside.complex, volumes}, polydec::Side::primal, 0,
                             {.time_step = 0.001, .scheme = polydec::HeatScheme::crank_nicolson});
    polydec::SvgSeries cooling{"n = " + std::to_string(n), {0}, {1}, polydec::SvgTrace::line};
    polydec::Cochain u = start;
    Film cooled("heat", box, inside);
    for (int i = 1; i <= 50; ++i) {
        u = heat.step(u);
        if (i % 10 == 0)
            cooled.add(0.001 * i, u.values);
        cooling.x.push_back(0.001 * i);
        cooling.y.push_back(amplitude(u));
    }

    // half a period turns the wave around
    const double half = 1 / std::sqrt(n),
                 bound = polydec::stable_step({inside.complex, volumes}, 0);
    const double steps = std::ceil(1.1 * half / bound), dt = half / steps;
    polydec::Waves wave({inside.complex, volumes}, start, {.time_step = dt});
    Film swung("waves", box, inside);
    for (int i = 1; i <= steps; ++i) {
        wave.advance();
        if (i % 4 == 0)
            swung.add(wave.time(), wave.form(0).values);
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
