// SPDX-License-Identifier: MIT
//
// Euler's equations on a sphere of hexagons, and on a torus of quads with a flow around its hole.
// Vortices meet; energy, circulation and zero divergence are preserved to rounding. The first
// argument is the number of steps.
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <polydec.h>

namespace {

void march(const std::string& name, const polydec::Discretization& mesh, double around, int steps) {
    const polydec::IncompressibleFlow flow(mesh);
    const auto bump = [](const auto& x, double y) {
        return std::exp(-15 * (std::pow(x[0] - 1, 2) + std::pow(x[1] - y, 2) + x[2] * x[2]));
    };
    const polydec::Vector vorticity =
        polydec::de_rham(mesh, 0, polydec::function_form([&](const auto& x) {
                             return 4 * (bump(x, 0.3) + bump(x, -0.3));
                         }))
            .values;
    polydec::Points wind(mesh.points().rows(), 3);
    for (polydec::Index v = 0; v < wind.rows(); ++v) {
        const double x = mesh.points()(v, 0), y = mesh.points()(v, 1), r2 = x * x + y * y + 1e-9;
        wind.row(v) << -y / r2, x / r2, 0;
    }
    polydec::Vector w = polydec::flow_of_vorticity(mesh, vorticity);
    if (around != 0)
        w += around * polydec::flow_of_velocity(mesh, wind);
    w = flow.project(w);

    const auto harmonic_part = [&] {
        const auto part = polydec::hodge_decomposition({mesh, polydec::Side::primal, 1},
                                                       {polydec::Side::primal, 1, w})
                              .harmonic;
        return std::sqrt(2 * flow.energy(part.values));
    };
    const double energy = flow.energy(w), harmonic = around != 0 ? harmonic_part() : 0;
    const double size = flow.circulations(w).cwiseAbs().sum();
    polydec::Flow vortices(flow, w, {.time_step = 0.4 * flow.exchange_time(w)});
    double drift = 0;
    for (int i = 0; i < steps; ++i) {
        vortices.advance();
        w = vortices.flux();
        drift = std::max(drift, std::abs(flow.energy(w) / energy - 1));
    }
    std::cout << name << ", " << steps << " steps to the time " << vortices.time()
              << ": energy off by " << drift << ", circulation by "
              << std::abs(flow.circulations(w).sum()) / size << ", divergence "
              << flow.divergence(w);
    if (around != 0)
        std::cout << ", harmonic part from " << harmonic << " to " << harmonic_part();
    std::cout << (drift < 1e-10 ? "; kept\n" : "; lost\n");
}

} // namespace

int main(int argc, char** argv) {
    const int steps = argc > 1 ? std::atoi(argv[1]) : 50;
    march("sphere", polydec::discretize(polydec::goldberg(6)), 0, steps);
    march("torus", polydec::discretize(polydec::torus(32, 16)), 0.3, steps);
}
