// SPDX-License-Identifier: MIT
#include "tests/dec/discretized.h"
#include "tests/solvers/flow_samples.h"

namespace polydec::test::in_flux_transport {

class FluxTransports : public OverMeshes {};

/// Any fluxes keep the mass but for what crosses the boundary, on any cells.
TEST_P(FluxTransports, keep_the_mass_to_rounding) {
    const auto mesh = circumcentric(mesh_named(GetParam()));
    const int n = mesh.dimension();
    for (const auto sampling : {Sampling::centered, Sampling::upwind}) {
        if (!is_two_sided(mesh)) {
            EXPECT_THROW(FluxTransport(mesh, sampling), InvalidInput);
            continue;
        }
        const FluxTransport transport(mesh, sampling);
        const Vector flux = random_vector(mesh.complex().size(n - 1), 1);
        const Vector density = random_vector(mesh.complex().size(n), 2);
        const Vector outside = random_vector(mesh.complex().size(n - 1), 3);
        const Vector through = transport.mass_flux(flux, density, outside);
        const double change = transport.mass(transport.rate(flux, density, outside));
        EXPECT_LE(std::abs(change + transport.outflow(through)),
                  1e-12 * (1 + through.cwiseAbs().sum()));
        // upwind, what is not negative stays so
        const Vector some = density.cwiseAbs();
        const double step = transport.stable_step(flux);
        if (sampling == Sampling::upwind && std::isfinite(step)) {
            EXPECT_GE((some + step * transport.rate(flux, some)).minCoeff(), -1e-14);
        }
    }
}

POLYDEC_OVER_MESHES(FluxTransports);

/// Extremes of a density that the flow of a porous medium carries through a square, 1 coming in
/// below, for as long as half of the content takes; and what is lacking of the mass.
struct Carried {
    double least, most, lacking;
};

Carried carried_by_darcy(const Discretization& mesh, Sampling sampling) {
    const Vector pressures =
        at(facet_sites(mesh), [](const Vector& p) { return -p[1] + 0.3 * std::sin(3 * p[0]); });
    const Vector none = Vector::Zero(mesh.complex().size(2));
    const Vector flux =
        solved(PoissonSolver(functions(mesh, Side::dual)), none, pressures).flux.values;

    const FluxTransport transport(mesh, sampling);
    const Vector outside = Vector::Ones(flux.size());
    const double step = 0.9 * transport.stable_step(flux);
    Vector density = none;
    double came = 0;
    for (double time = 0; time < 0.5; time += step) {
        came -= step * transport.outflow(transport.mass_flux(flux, density, outside));
        density += step * transport.rate(flux, density, outside);
    }
    return {density.minCoeff(), density.maxCoeff(),
            std::abs(came - transport.mass(density)) / transport.mass(density)};
}

TEST(FluxTransport, by_the_flow_of_a_porous_medium_keeps_mass_and_range) {
    for (const char* shape : {"quads", "triangles", "hexagons"}) {
        const auto mesh = circumcentric(square(shape, 16));
        const auto upwind = carried_by_darcy(mesh, Sampling::upwind);
        EXPECT_GE(upwind.least, -1e-12) << shape;
        EXPECT_LE(upwind.most, 1 + 1e-12) << shape;
        EXPECT_LE(upwind.lacking, 1e-13) << shape;
        const auto centered = carried_by_darcy(mesh, Sampling::centered);
        EXPECT_LE(centered.lacking, 1e-12) << shape;
        EXPECT_GT(centered.most, 1.01) << shape;
    }
}

/// Relative error of a bump that a vortex has carried forth and back again.
double error_after_return(int cells, Sampling sampling) {
    Mesh square = grid(cells, cells, 2, 2);
    square.points.array() -= 1;
    const auto mesh = circumcentric(square);
    const Vector flux = flow_of(mesh, [](const Vector& x) {
        return -std::pow(std::cos(pi * x[0] / 2) * std::cos(pi * x[1] / 2), 2);
    });
    const Points centers = cell_centers(mesh, 2);
    Vector start(centers.rows());
    for (Index c = 0; c < start.size(); ++c)
        start[c] = std::exp(-5 * (centers.row(c) - Eigen::RowVector2d(0.3, 0)).squaredNorm());
    const FluxTransport transport(mesh, sampling);
    // by steps of second order
    Vector density = start;
    const int steps = 4 * cells;
    for (const double sign : {1., -1.})
        for (int i = 0; i < steps; ++i) {
            const double dt = 0.25 / steps;
            const Vector half = density + dt / 2 * transport.rate(sign * flux, density);
            density += dt * transport.rate(sign * flux, half);
        }
    return (density - start).norm() / start.norm();
}

TEST(FluxTransport, is_of_first_order_upwind_and_of_second_centered) {
    const auto order = [](Sampling sampling) {
        return std::log2(error_after_return(48, sampling) / error_after_return(96, sampling));
    };
    EXPECT_NEAR(order(Sampling::upwind), 0.9, 0.2);
    EXPECT_GT(order(Sampling::centered), 1.8);
}

TEST(FluxTransportErrors, name_the_numbers) {
    const FluxTransport transport(circumcentric(grid(2, 2)));
    EXPECT_REFUSED(transport.rate(Vector::Ones(3), Vector::Ones(4)), "3 fluxes", "12");
    EXPECT_REFUSED(transport.rate(Vector::Ones(12), Vector::Ones(3)), "3 densities", "4");
}

TEST(FluxTransportErrors, name_the_value_that_is_not_finite) {
    const FluxTransport transport(circumcentric(grid(2, 2)));
    const Vector fluxes = Vector::Ones(12), densities = Vector::Ones(4);
    for (const double none : {NAN, INFINITY}) {
        Vector bad_fluxes = fluxes, bad_densities = densities;
        bad_fluxes[5] = bad_densities[2] = none;
        EXPECT_REFUSED(transport.rate(bad_fluxes, densities), "fluxes", "value 5");
        EXPECT_REFUSED(transport.rate(fluxes, bad_densities), "densities", "value 2");
        EXPECT_REFUSED(transport.rate(fluxes, densities, bad_fluxes), "densities outside",
                       "value 5");
        EXPECT_REFUSED(transport.stable_step(bad_fluxes), "fluxes", "value 5");
        EXPECT_REFUSED(transport.outflow(bad_fluxes), "mass fluxes", "value 5");
        EXPECT_REFUSED(transport.mass(bad_densities), "densities", "value 2");
    }
}

} // namespace polydec::test::in_flux_transport
