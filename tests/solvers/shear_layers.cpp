// SPDX-License-Identifier: MIT
#include "tests/solvers/flow_samples.h"

namespace polydec::test::in_shear_layers {

/// The unit square glued at opposite sides.
PeriodicMesh flat_torus(const std::string& shape, int cells) {
    return periodic(square(shape, cells), {Vector{{1, 0}}, Vector{{0, 1}}});
}

/// The stream function of two layers of this width in which the wind along x turns around, bent
/// by a twentieth of the wind (Bell, Colella, Glaz, J. Comput. Phys. 85, 1989).
double layers(const Vector& x, double width) {
    const auto one = [&](double y) { return width * std::log(std::cosh(y / width)); };
    const double along = x[1] <= 0.5 ? one(x[1] - 0.25) : 2 * one(0.25) - one(0.75 - x[1]);
    return along + 0.05 * std::cos(2 * pi * x[0]) / (2 * pi);
}

Vector flow_of_layers(const PeriodicMesh& box, const Discretization& mesh, double width) {
    Vector stream(mesh.complex().size(0));
    for (Index v = 0; v < stream.size(); ++v)
        stream[v] = layers(box.points.row(v).transpose(), width);
    return d(mesh.complex(), {Side::primal, 0, stream}).values;
}

TEST(ShearLayers, keep_energy_and_circulation_while_they_roll_up) {
    for (const char* shape : {"quads", "triangles"}) {
        const auto box = flat_torus(shape, 24);
        const auto mesh = circumcentric(box.quotient);
        const IncompressibleFlow flow(mesh);
        const Vector start = flow.project(flow_of_layers(box, mesh, 1. / 15));
        const double energy = flow.energy(start);
        const double size = flow.circulations(start).cwiseAbs().sum();
        Flow rolling(flow, start, {.time_step = 0.4 * flow.exchange_time(start)});
        rolling.advance(100);
        const Vector& w = rolling.flux();
        EXPECT_NEAR(flow.energy(w) / energy, 1, 1e-11) << shape;
        EXPECT_LE(std::abs(flow.circulations(w).sum()), 1e-13 * size) << shape;
        EXPECT_LE(flow.divergence(w), 1e-12) << shape;
        EXPECT_GT(flow_error(flow, w, start), 0.1) << shape << ": nothing moves";
    }
}

/// Of rolled layers on so many quads to a side, by sixteenths.
std::map<std::pair<long, long>, double> vorticity_of_layers(int cells, double viscosity) {
    const auto box = flat_torus("quads", cells);
    const auto mesh = circumcentric(box.quotient);
    const IncompressibleFlow flow(mesh, {.viscosity = viscosity});
    constexpr double time = 0.5;
    Flow rolling(flow, flow.project(flow_of_layers(box, mesh, 1. / 7)),
                 {.time_step = time / (2 * cells), .scheme = FlowScheme::imex});
    rolling.march(time);
    const Vector z = flow.vorticity(rolling.flux());
    std::map<std::pair<long, long>, double> result;
    for (Index v = 0; v < z.size(); ++v) {
        const double x = 16 * box.points(v, 0), y = 16 * box.points(v, 1);
        if (std::abs(x - std::round(x)) + std::abs(y - std::round(y)) < 1e-6)
            result[{std::lround(x) % 16, std::lround(y) % 16}] = z[v];
    }
    return result;
}

double largest_difference(const std::map<std::pair<long, long>, double>& one,
                          const std::map<std::pair<long, long>, double>& other) {
    double worst = 0;
    for (const auto& [place, value] : one)
        worst = std::max(worst, std::abs(value - other.at(place)));
    return worst;
}

TEST(ShearLayers, roll_up_with_order_2) {
    constexpr double nu = 2e-3;
    const auto coarse = vorticity_of_layers(16, nu), middle = vorticity_of_layers(32, nu),
               fine = vorticity_of_layers(64, nu);
    ASSERT_EQ(coarse.size(), 256u);
    const double first = largest_difference(coarse, middle);
    const double second = largest_difference(middle, fine);
    EXPECT_GE(std::log2(first / second), 1.8) << first << ' ' << second;
    EXPECT_LE(second, 0.2);
    // other friction gives other layers
    EXPECT_GT(largest_difference(vorticity_of_layers(16, 8 * nu), coarse), 5 * second);
}

} // namespace polydec::test::in_shear_layers
