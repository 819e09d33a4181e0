// SPDX-License-Identifier: MIT
//
// docs/flow.md: vortices on a sphere, a cavity with a moving lid, salt in a porous medium, water on
// a planet.
#include <cmath>
#include <iostream>
#include <polydec.h>

namespace {

polydec::Vector at_vertices(const polydec::Discretization& mesh, auto function) {
    return polydec::de_rham(mesh, 0, polydec::function_form(function)).values;
}

void vortices() {
    const auto sphere = polydec::discretize(polydec::goldberg(8));
    const polydec::IncompressibleFlow flow(sphere);
    const auto vorticity = at_vertices(sphere, [](const auto& x) {
        return std::exp(-20 * (std::pow(x[1] - 0.4, 2) + x[2] * x[2])) -
               std::exp(-20 * (std::pow(x[1] + 0.4, 2) + x[2] * x[2]));
    });
    const auto start = flow.project(polydec::flow_of_vorticity(sphere, vorticity));
    const double before = flow.energy(start);
    polydec::Flow vortices(flow, start, {.time_step = 0.5 * flow.exchange_time(start)});
    vortices.advance(100);
    const polydec::Vector& w = vortices.flux();
    std::cout << "energy kept to 1e-11: "
              << (std::abs(flow.energy(w) / before - 1) < 1e-11 ? "yes" : "no")
              << ", divergence below 1e-13: " << (flow.divergence(w) < 1e-13 ? "yes" : "no")
              << '\n';
}

void cavity() {
    const auto square = polydec::discretize(polydec::grid(24, 24));
    const polydec::Points walls = polydec::facet_sites(square);
    polydec::FlowOptions options{.viscosity = 0.01, .everywhere = polydec::FlowBoundary::no_slip};
    options.wall_velocity = polydec::Points::Zero(walls.rows(), 2);
    for (polydec::Index f = 0; f < walls.rows(); ++f)
        options.wall_velocity(f, 0) = walls(f, 1) > 0.999 ? 1 : 0;
    const polydec::IncompressibleFlow flow(square, options);
    const auto rest = flow.project(polydec::Vector::Zero(walls.rows()));
    polydec::Flow moving(flow, rest, {.time_step = 0.03, .scheme = polydec::FlowScheme::imex});
    moving.march(12);
    const auto velocity = polydec::flux_sharp(square, moving.form(0));
    std::cout << "velocity in the middle of the cavity: "
              << (velocity(24 * 11 + 11, 0) + velocity(24 * 12 + 12, 0)) / 2 << '\n';
}

void salt() {
    const auto rock = polydec::discretize(polydec::hexagons(16));
    const polydec::PoissonSolver darcy({rock, polydec::Side::dual, 0, {}});
    const polydec::Points facets = polydec::facet_sites(rock);
    const polydec::Vector none = polydec::Vector::Zero(rock.complex().size(2));
    const polydec::Vector flux =
        darcy.solve({polydec::Side::dual, 0, none}, {.values = -facets.col(0)}).flux.values;
    const polydec::FluxTransport transport(rock);
    const polydec::Vector salty = polydec::Vector::Ones(facets.rows());
    polydec::Vector density = none;
    double came = 0;
    for (int i = 0; i < 100; ++i) {
        const double step = 0.9 * transport.stable_step(flux);
        came -= step * transport.outflow(transport.mass_flux(flux, density, salty));
        density += step * transport.rate(flux, density, salty);
    }
    std::cout << "salt that came in and is not there: "
              << (std::abs(came - transport.mass(density)) < 1e-13 ? "none" : "some")
              << ", densities from 0 to 1: "
              << (density.minCoeff() > -1e-12 && density.maxCoeff() < 1 + 1e-12 ? "yes" : "no")
              << '\n';
}

void water() {
    const auto planet = polydec::discretize(polydec::goldberg(8));
    const auto rotation = at_vertices(planet, [](const auto& x) { return 2 * x[2]; });
    const polydec::ShallowWater water(planet, {.gravity = 1, .rotation = rotation});
    const polydec::Points cells = polydec::cell_centers(planet, 2);
    polydec::ShallowWater::State state{polydec::Vector::Ones(cells.rows()),
                                       polydec::Vector::Zero(planet.complex().size(1))};
    for (polydec::Index c = 0; c < cells.rows(); ++c)
        state.depth[c] += 0.2 * std::exp(-10 * (cells(c, 0) - 1) * (cells(c, 0) - 1));
    const double mass = water.mass(state), energy = water.energy(state);
    polydec::Evolution run({{{planet, polydec::Side::dual, 0}, state.depth},
                            {{planet, polydec::Side::primal, 1}, state.flux}},
                           water, {.steps = {.relative_tolerance = 1e-8}});
    run.march(5);
    state = {run.forms()[0].values, run.forms()[1].values};
    std::cout << "mass kept to 1e-14: "
              << (std::abs(water.mass(state) / mass - 1) < 1e-14 ? "yes" : "no")
              << ", energy to 1e-6: "
              << (std::abs(water.energy(state) / energy - 1) < 1e-6 ? "yes" : "no") << '\n';
}

} // namespace

int main() {
    vortices();
    cavity();
    salt();
    water();
}
