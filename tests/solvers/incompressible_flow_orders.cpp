// SPDX-License-Identifier: MIT
#include "tests/solvers/flow_samples.h"

namespace polydec::test::in_incompressible_flow_orders {

double taylor_green(const Vector& x) {
    return std::sin(x[0]) * std::sin(x[1]);
}

/// Relative error after the time 1 of Taylor and Green's vortex between walls without friction,
/// which decays by exp(-2 nu t), or as with another viscosity.
double error_of_vortex(const IncompressibleFlow& flow, const Vector& start, int steps,
                       FlowScheme scheme, double viscosity = 0.05) {
    Flow vortex(flow, flow.project(start), {.time_step = 1.0 / steps, .scheme = scheme});
    vortex.march(1);
    return flow_error(flow, vortex.flux(), std::exp(-2 * viscosity) * start);
}

TEST(TaylorGreenVortices, decay_with_order_2_on_quads_triangles_and_hexagons) {
    for (const char* shape : {"quads", "triangles", "hexagons"})
        for (const auto scheme : {FlowScheme::implicit_midpoint, FlowScheme::imex}) {
            std::vector<double> errors;
            for (const int cells : {12, 24}) {
                const auto mesh = circumcentric(square(shape, cells, pi));
                const IncompressibleFlow flow(mesh, {.viscosity = 0.05});
                errors.push_back(error_of_vortex(flow, flow_of(mesh, taylor_green), cells, scheme));
            }
            EXPECT_LE(errors[1], 3e-3) << shape;
            EXPECT_GT(std::log2(errors[0] / errors[1]), 1.7) << shape;
            // with another viscosity it is another vortex
            const auto mesh = circumcentric(square(shape, 10, pi));
            EXPECT_GT(error_of_vortex(IncompressibleFlow(mesh, {.viscosity = 0.05}),
                                      flow_of(mesh, taylor_green), 10, scheme, 0.1),
                      0.05)
                << shape;
        }
}

TEST(TaylorGreenVortices, decay_with_order_2_in_cubes) {
    std::vector<double> errors;
    for (const int cells : {5, 10}) {
        Mesh cube = kuhn(3, cells);
        cube.points *= pi;
        const auto mesh = circumcentric(cube);
        const Cochain potential = de_rham(mesh, 1, [](const Vector& x) {
            return Vector{{0, 0, taylor_green(x)}};
        });
        const IncompressibleFlow flow(mesh, {.viscosity = 0.05});
        errors.push_back(
            error_of_vortex(flow, d(mesh.complex(), potential).values, cells, FlowScheme::imex));
    }
    EXPECT_LE(errors[1], 0.02);
    EXPECT_GT(std::log2(errors[0] / errors[1]), 1.7);
}

/// Mean square error of the pressure of Taylor and Green's vortex, (cos 2x + cos 2y) / 4, relative.
double error_of_pressure(const std::string& shape, int cells) {
    const auto mesh = circumcentric(square(shape, cells, pi));
    const IncompressibleFlow flow(mesh);
    const Vector p = flow.pressure(flow.project(flow_of(mesh, taylor_green))).values;
    const Points centers = cell_centers(mesh, 2);
    double error = 0, size = 0;
    for (Index c = 0; c < p.size(); ++c) {
        const double exact = (std::cos(2 * centers(c, 0)) + std::cos(2 * centers(c, 1))) / 4;
        error += mesh.volumes().primal(2)[c] * std::pow(p[c] - exact, 2);
        size += mesh.volumes().primal(2)[c] * exact * exact;
    }
    return std::sqrt(error / size);
}

TEST(TaylorGreenVortices, have_their_pressure) {
    for (const auto& [shape, order] :
         {std::pair("quads", 1.8), {"hexagons", 1.7}, {"triangles", 0.9}}) {
        const double coarse = error_of_pressure(shape, 12), fine = error_of_pressure(shape, 24);
        EXPECT_LE(fine, 0.06) << shape;
        EXPECT_GT(std::log2(coarse / fine), order) << shape;
    }
}

} // namespace polydec::test::in_incompressible_flow_orders
