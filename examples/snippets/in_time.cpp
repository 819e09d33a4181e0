// SPDX-License-Identifier: MIT
//
// docs/in_time.md: heat that stops in the middle and resumes; heat with a source; a user-defined
// equation.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <polydec.h>

namespace {

/// Heat up to a time, from a checkpoint or from the start.
polydec::Vector heat_until(double end, const polydec::Discretization& sphere,
                           const polydec::Cochain& start) {
    polydec::Evolution heat(
        {{.space = {sphere, polydec::Side::primal, 0}, .start = start.values, .diffusion = 1}}, {},
        {.integrator = "backward-euler", .steps = {.fixed_step = 0.01}});
    polydec::Frames frames(
        heat, {0.1, 0.2, 0.3, 0.4, 0.5},
        {.checkpoint = "heat.checkpoint", .stop = [&] { return heat.time() > end; }});
    std::cout << "from " << heat.time();
    while (frames.next()) {
    }
    std::cout << " to " << heat.time() << '\n';
    return heat.form(0).values;
}

/// The error of heat in a square with the source that makes u = cos(t) cos(pi x) cos(pi y).
double error_with_source(int cells, double tolerance) {
    constexpr double pi = std::numbers::pi;
    const auto square = polydec::discretize(polydec::kuhn(2, cells));
    const auto wave = polydec::de_rham(square, 0, polydec::function_form([](const auto& x) {
                                           return std::cos(pi * x[0]) * std::cos(pi * x[1]);
                                       }));
    const auto source = [&](double t, const std::vector<polydec::Cochain>&) {
        return std::vector<polydec::Vector>{(2 * pi * pi * std::cos(t) - std::sin(t)) *
                                            wave.values};
    };
    polydec::Evolution heat(
        {{.space = {square, polydec::Side::primal, 0}, .start = wave.values, .diffusion = 1}},
        source, {.steps = {.relative_tolerance = tolerance}});
    heat.march(1);
    return polydec::norm(square, heat.form(0) - std::cos(1) * wave);
}

/// A population that invades empty space: a front of speed 2 sqrt(nu r).
double speed_of_front() {
    const double nu = 1e-3, r = 4;
    const auto strip = polydec::discretize(polydec::kuhn(1, 400));
    const auto u0 = polydec::de_rham(
        strip, 0, polydec::function_form([](const auto& x) { return x[0] < 0.1 ? 1.0 : 0.0; }));
    const auto growth = [&](double, const std::vector<polydec::Cochain>& now) {
        const auto u = now[0].values.array();
        return std::vector<polydec::Vector>{r * u * (1 - u)};
    };
    polydec::Evolution front(
        {{.space = {strip, polydec::Side::primal, 0}, .start = u0.values, .diffusion = nu}},
        growth);
    const auto amount = [&] {
        return polydec::star(strip, 0).diagonal().dot(front.form(0).values);
    };
    front.march(3);
    const double before = amount();
    front.march(5);
    return (amount() - before) / 2 / (2 * std::sqrt(nu * r));
}

/// Amplitude of the ground temperature at depth 1, for amplitude 1 at the surface.
double swing_below() {
    auto depth = polydec::kuhn(1, 60);
    depth.points *= 6;
    const auto ground = polydec::discretize(depth);
    const polydec::Vector cold = polydec::Vector::Zero(61);
    const auto surface = polydec::essential_where(polydec::facet_sites(ground),
                                                  [](const auto& x) { return x[0] < 1e-9; });
    const auto weather = [](double t) {
        return polydec::BoundaryForms{.values = polydec::Vector::Constant(61, std::cos(t))};
    };
    polydec::Evolution heat({{.space = {ground, polydec::Side::primal, 0, surface},
                              .start = cold,
                              .diffusion = 1,
                              .boundary = weather}});
    double most = 0;
    for (double t = 40; t < 40 + 2 * std::numbers::pi; t += 0.05) {
        heat.march(t);
        most = std::max(most, heat.form(0).values[10]);
    }
    return most;
}

} // namespace

int main() {
    const auto sphere = polydec::discretize(polydec::icosphere(16));
    const polydec::Cochain start =
        polydec::de_rham(sphere, 0, polydec::function_form([](const auto& x) { return x[2]; }));
    std::filesystem::remove("heat.checkpoint");
    const polydec::Vector whole = heat_until(1, sphere, start);
    std::filesystem::remove("heat.checkpoint");
    heat_until(0.215, sphere, start);
    const polydec::Vector resumed = heat_until(1, sphere, start);
    std::cout << "difference " << (whole - resumed).cwiseAbs().maxCoeff() << '\n'
              << "largest value " << whole.maxCoeff() << ", exp(-1) = " << std::exp(-1) << '\n';
    std::filesystem::remove("heat.checkpoint");
    const double coarse = error_with_source(8, 1e-8), fine = error_with_source(16, 1e-8);
    std::cout << "with a source, order in space " << std::log2(coarse / fine) << '\n'
              << "speed of the front " << speed_of_front() << " of that of an infinite one\n"
              << "the ground swings by " << swing_below()
              << ", exp(-1 / sqrt 2) = " << std::exp(-std::sqrt(0.5)) << '\n';
}
