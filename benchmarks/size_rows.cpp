// SPDX-License-Identifier: MIT
#include "benchmarks/chain.h"
#include "benchmarks/rows.h"
#include "dec/discretization/discretization.h"
#include "meshes/generate.h"

#include <algorithm>
#include <cmath>

namespace polydec::benchmarks {

namespace {

using Maker = Mesh (*)(double cells);

Mesh torus_of(double cells) {
    const int across = std::max(3, static_cast<int>(std::lround(std::sqrt(cells / 4))));
    return torus(2 * across, across);
}

Mesh boxes_of(double cells) {
    return kuhn(3, std::max(1, static_cast<int>(std::lround(std::cbrt(cells / 6)))));
}

void add_sizes(const std::string& name, Maker make, const Settings& settings) {
    const double largest = settings.smoke ? 1e3 : 1e7;
    for (double cells = settings.smoke ? 1e2 : 1e4; cells <= 1.01 * largest; cells *= 10) {
        const auto mesh = shared_mesh([=] { return make(cells); });
        const int rounds = cells > 3e6 ? std::min(settings.rounds, 2) : settings.rounds;
        const std::string size = "/1e" + std::to_string(std::lround(std::log10(cells)));
        add_row("size/" + name + "/chain" + size, rounds, [=](benchmark::State& state) {
            measure(state, mesh->amount(), [&] { return chain(mesh->get()); });
        });
        add_row("size/" + name + "/merged" + size, rounds, [=](benchmark::State& state) {
            measure(state, mesh->amount(), [&] { return discretize(mesh->get()); });
        });
    }
}

} // namespace

void add_size_rows(const Settings& settings) {
    add_sizes("torus", torus_of, settings);
    add_sizes("tets", boxes_of, settings);
}

} // namespace polydec::benchmarks
