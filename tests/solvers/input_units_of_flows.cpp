// SPDX-License-Identifier: MIT
#include "tests/solvers/cases.h"
#include "tests/support/all_sizes.h"

namespace polydec::test::in_input_units_of_flows {

const std::vector<std::string> surfaces{"grid4", "wellcentred4", "icosphere3"};

Vector any_flux(const Discretization& mesh, double size, unsigned seed) {
    const int n = mesh.dimension();
    return std::pow(size, n) * random_vector(mesh.complex().size(n - 1), seed);
}

/// A row of velocities for each k-cell.
Points any_velocities(const Discretization& mesh, double size, int k, unsigned seed) {
    const Index rows = mesh.complex().size(k), N = mesh.ambient_dimension();
    return size * random_vector(rows * N, seed).reshaped(rows, N);
}

TEST(InputUnits, are_those_of_pressures_and_fluxes) {
    expect_no_unit({1}, [](const Discretization& mesh, double size, Side side, int) {
        const bool essential = side == Side::primal || mesh.complex().size(0) > 60;
        const PoissonSolver solver(
            functions(mesh, Side::dual,
                      {essential ? BoundaryCondition::essential : BoundaryCondition::natural}));
        const int n = mesh.dimension();
        const Index facets = mesh.complex().size(n - 1);
        const auto flow = solved(solver, random_vector(mesh.complex().size(n), 3) / (size * size),
                                 random_vector(facets, 4), -random_vector(facets, 5) / size);
        return joined({flow.form.values, flow.flux.values / std::pow(size, n - 2)});
    });
}

TEST(InputUnits, are_those_of_slow_flows) {
    expect_no_unit({1}, [](const Discretization& mesh, double size, Side, int) {
        const int n = mesh.dimension();
        const StokesSolver solver(mesh, {.viscosity = 0.3 * size * size});
        StokesData data;
        data.along = size * size * random_vector(mesh.complex().size(n - 2), 2);
        const auto flow = solver.solve({Side::primal, n - 1, any_flux(mesh, size, 1)}, data);
        return joined({flow.flux.values / std::pow(size, n),
                       flow.vorticity.values / std::pow(size, n - 2),
                       flow.pressure.values / (size * size)});
    });
}

TEST(InputUnits, are_those_of_flows_with_inertia) {
    expect_no_unit({1}, [](const Discretization& mesh, double size, Side side, int) {
        const int n = mesh.dimension();
        FlowOptions options{.viscosity = 0.1 * size * size, .everywhere = FlowBoundary::no_slip};
        options.wall_velocity = any_velocities(mesh, size, n - 1, 6);
        options.rotation = std::pow(size, n - 2) * random_vector(mesh.complex().size(n - 2), 7);
        const IncompressibleFlow flow(mesh, options);
        const Vector start = flow.project(any_flux(mesh, size, 1));
        const double step = 0.1 * flow.exchange_time(start);
        Flow moving(
            flow, start,
            {.time_step = step,
             .scheme = side == Side::primal ? FlowScheme::implicit_midpoint : FlowScheme::imex});
        moving.advance();
        const Vector w = moving.flux();
        return joined(
            {w / std::pow(size, n), flow.rate(w) / std::pow(size, n),
             flow.vorticity(w) / std::pow(size, n - 2), flow.pressure(w).values / (size * size),
             flow.circulations(w) / (size * size), Vector{{step, flow.relative_energy(w, start)}}});
    });
}

TEST(InputUnits, are_those_of_what_flows_begin_with) {
    expect_no_unit({1}, [](const Discretization& mesh, double size, Side, int) {
        const int n = mesh.dimension();
        const Vector z = random_vector(mesh.complex().size(0), 3);
        std::vector<Vector> fluxes{
            flow_of_velocity(mesh, any_velocities(mesh, size, 0, 1)),
            flux_through_boundary(mesh, any_velocities(mesh, size, n - 1, 2))};
        if (n == 2)
            fluxes.push_back(flow_of_vorticity(mesh, z));
        return Vector(joined(fluxes) / std::pow(size, n));
    });
}

TEST(InputUnits, are_those_of_shallow_water) {
    expect_no_unit({1, surfaces}, [](const Discretization& mesh, double size, Side, int) {
        const Index cells = mesh.complex().size(2);
        const ShallowWater water(mesh, {.gravity = 9 * size,
                                        .rotation = random_vector(mesh.complex().size(0), 2),
                                        .bottom = size * 0.1 * random_vector(cells, 3)});
        ShallowWater::State state{size * (Vector::Ones(cells) + 0.1 * random_vector(cells, 4)),
                                  0.1 * any_flux(mesh, size, 5)};
        for (Index e = 0; e < state.flux.size(); ++e)
            if (mesh.complex().coface_counts(1)[e] == 1)
                state.flux[e] = 0;
        const double stable = water.stable_step(state);
        const ShallowWater::State rate = water.rate(state);
        return joined({rate.depth / size, rate.flux / (size * size),
                       size * water.potential_vorticity(state),
                       Vector{{stable, water.mass(state) / std::pow(size, 3),
                               water.potential_enstrophy(state) / size}}});
    });
}

TEST(InputUnits, are_those_of_transport) {
    expect_no_unit({1}, [](const Discretization& mesh, double size, Side side, int) {
        const int n = mesh.dimension();
        const FluxTransport transport(mesh,
                                      side == Side::primal ? Sampling::upwind : Sampling::centered);
        const Vector flux = any_flux(mesh, size, 1),
                     density = random_vector(mesh.complex().size(n), 2);
        return joined(
            {transport.rate(flux, density),
             Vector{{transport.stable_step(flux), transport.mass(density) / std::pow(size, n)}}});
    });
}

// Energies are powers of lengths that may be no numbers.
TEST(InputUnits, of_energies_are_refused_where_they_are_no_numbers) {
    Mesh mesh = mesh_named("kuhn3");
    mesh.points *= 0x1p-300;
    const IncompressibleFlow flow(discretize(mesh));
    const Vector w = flow.project(any_flux(flow.mesh(), 0x1p-300, 1));
    EXPECT_SAYS(refusal([&] { return flow.energy(w); }), "energy", "scale");
    EXPECT_NEAR(flow.relative_energy(2 * w, w), 4, 1e-12);
}

} // namespace polydec::test::in_input_units_of_flows
