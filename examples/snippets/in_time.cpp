// SPDX-License-Identifier: MIT
//
// docs/in_time.md: heat that is stopped in the middle and gone on with.
#include <cmath>
#include <filesystem>
#include <iostream>
#include <polydec.h>

namespace {

/// Steps of a problem up to a time, from where a checkpoint says or from the start.
polydec::Vector heat_until(double end, const polydec::Discretization& sphere,
                           const polydec::Cochain& start) {
    const double dt = 0.01;
    const polydec::HeatSolver heat(sphere, start.side, start.degree, {.time_step = dt});
    const auto problem = polydec::Fingerprint().add(sphere).add(start.values).add(dt).value();
    polydec::Checkpoint now{problem, 0, 0, {start.values}};
    if (std::filesystem::exists("heat.checkpoint"))
        now = polydec::read_checkpoint("heat.checkpoint", problem);
    std::cout << "from step " << now.step;
    while (now.time < end - dt / 2) {
        now.state[0] = heat.step({start.side, start.degree, now.state[0]}).values;
        now.time = dt * static_cast<double>(++now.step);
        if (now.step % 5 == 0)
            polydec::write_checkpoint("heat.checkpoint", now);
    }
    std::cout << " to step " << now.step << '\n';
    return now.state[0];
}

} // namespace

int main() {
    const auto sphere = polydec::discretize(polydec::icosphere(16));
    const polydec::Cochain start =
        polydec::de_rham(sphere, 0, polydec::function_form([](const auto& x) { return x[2]; }));
    std::filesystem::remove("heat.checkpoint");
    const polydec::Vector whole = heat_until(0.5, sphere, start);
    std::filesystem::remove("heat.checkpoint");
    heat_until(0.22, sphere, start);
    const polydec::Vector resumed = heat_until(0.5, sphere, start);
    std::cout << "difference " << (whole - resumed).cwiseAbs().maxCoeff() << '\n'
              << "largest value " << whole.maxCoeff() << ", exp(-1) = " << std::exp(-1) << '\n';
    std::filesystem::remove("heat.checkpoint");
}
