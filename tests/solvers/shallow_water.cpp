// SPDX-License-Identifier: MIT
#include "tests/solvers/flow_samples.h"

namespace polydec::test::in_shallow_water {

using State = ShallowWater::State;

/// Any state: depths around 2, walls not crossed.
State some_state(const Discretization& mesh, unsigned seed) {
    State state{random_vector(mesh.complex().size(2), seed) / 2,
                0.2 * random_vector(mesh.complex().size(1), seed + 1)};
    state.depth.array() += 2;
    for (Index e = 0; e < state.flux.size(); ++e)
        if (mesh.complex().coface_counts(1)[e] == 1)
            state.flux[e] = 0;
    return state;
}

TEST(ShallowWaters, keep_mass_and_energy_on_any_cells) {
    for (const auto& [name, mesh] : {std::pair("quads", grid(5, 4)),
                                     {"hexagons", hexagons(5)},
                                     {"triangles", well_centered(4)},
                                     {"sphere", icosphere(4)},
                                     {"goldberg", goldberg(3)},
                                     {"torus", torus(16, 10)}}) {
        const auto on = circumcentric(mesh);
        ShallowWaterOptions options{.gravity = 3};
        options.rotation = random_vector(on.complex().size(0), 5);
        options.bottom = 0.2 * random_vector(on.complex().size(2), 6);
        const ShallowWater water(on, options);
        const State state = some_state(on, 1), rate = water.rate(state);
        EXPECT_LE(std::abs(on.volumes().primal(2).dot(rate.depth)),
                  1e-12 * rate.depth.cwiseAbs().sum())
            << name;
        // the derivative of the energy along the rate, by differences of third order
        const auto energy = [&](double part) {
            return water.energy({state.depth + part * rate.depth, state.flux + part * rate.flux});
        };
        const double part = 1e-2 / (rate.depth.norm() + rate.flux.norm());
        const double slope =
            (8 * (energy(part) - energy(-part)) - (energy(2 * part) - energy(-2 * part))) /
            (12 * part);
        const double scale = rate.flux.norm() + rate.depth.norm();
        EXPECT_LE(std::abs(slope), 1e-9 * scale) << name;
        // along half of it, it changes
        const double broken =
            water.energy({state.depth + part * rate.depth, state.flux}) - energy(0);
        EXPECT_GT(std::abs(broken / part), 1e-4 * scale) << name;
    }
}

TEST(ShallowWaters, at_rest_over_any_bottom_stay_at_rest) {
    const auto mesh = circumcentric(goldberg(4));
    ShallowWaterOptions options;
    options.bottom = 0.3 * random_vector(mesh.complex().size(2), 3);
    options.rotation = at(mesh.points(), [](const Vector& x) { return x[2]; });
    const ShallowWater water(mesh, options);
    const State still{1 - options.bottom.array(), Vector::Zero(mesh.complex().size(1))};
    const State rate = water.rate(still);
    EXPECT_LE(rate.depth.norm() + rate.flux.norm(), 1e-12);
}

State after(double time, const Discretization& mesh, const ShallowWater& water, const State& start,
            double tolerance) {
    Evolution run({{{mesh, Side::dual, 0}, start.depth}, {{mesh, Side::primal, 1}, start.flux}},
                  water, {.steps = {.relative_tolerance = tolerance}});
    run.march(time);
    return {run.forms()[0].values, run.forms()[1].values};
}

/// Williamson's second test: a steady wind around the axis, in balance with the rotation of the
/// frame. Relative error of the depth after a quarter of a turn.
double error_of_wind(const Mesh& sphere) {
    const auto mesh = circumcentric(sphere);
    constexpr double wind = 0.3, omega = 1, gravity = 1;
    ShallowWaterOptions options{.gravity = gravity};
    options.rotation = at(mesh.points(), [](const Vector& x) { return 2 * omega * x[2]; });
    const ShallowWater water(mesh, options);
    const Points centers = cell_centers(mesh, 2);
    Vector depth(centers.rows());
    for (Index c = 0; c < depth.size(); ++c) {
        const double z = centers(c, 2) / centers.row(c).norm();
        depth[c] = 2 - (omega * wind + wind * wind / 2) * z * z / gravity;
    }
    Vector flux = flow_of(mesh, [](const Vector& x) { return wind * x[2]; });
    if (water.potential_vorticity({depth, flux}).dot(options.rotation) <
        water.potential_vorticity({depth, -flux}).dot(options.rotation))
        flux = -flux; // eastwards
    State state{depth, flux};
    const double mass = water.mass(state), energy = water.energy(state);
    state = after(pi / 2, mesh, water, state, 1e-8);
    EXPECT_LE(std::abs(water.mass(state) / mass - 1), 1e-14);
    EXPECT_LE(std::abs(water.energy(state) / energy - 1), 1e-6);
    const Vector& areas = mesh.volumes().primal(2);
    return std::sqrt(areas.dot((state.depth - depth).cwiseAbs2()) / areas.dot(depth.cwiseAbs2()));
}

TEST(ShallowWaters, keep_a_steady_wind_with_order_2_on_quads_and_1_on_hexagons) {
    const double hexagons = error_of_wind(goldberg(6)), finer = error_of_wind(goldberg(12));
    EXPECT_LE(finer, 2e-3);
    EXPECT_GT(std::log2(hexagons / finer), 1.2);
    const double quads = error_of_wind(uv_sphere(24, 12)), fine = error_of_wind(uv_sphere(48, 24));
    EXPECT_LE(fine, 4e-3);
    EXPECT_GT(std::log2(quads / fine), 1.7);
}

/// Changes by its rate, by central differences.
TEST(ShallowWaters, evolve_by_their_rate) {
    for (const Mesh& input : {grid(5, 4), goldberg(3)}) {
        const auto mesh = circumcentric(input);
        const ShallowWater water(mesh, {.gravity = 3});
        const State start = some_state(mesh, 1), rate = water.rate(start);
        const double dt = 1e-3 * water.stable_step(start);
        const State later = after(dt, mesh, water, start, 1e-10),
                    last = after(2 * dt, mesh, water, start, 1e-10);
        const auto slope = [&](const Vector& a, const Vector& b, const Vector& c) -> Vector {
            return (4 * b - 3 * a - c) / (2 * dt);
        };
        EXPECT_LE((slope(start.depth, later.depth, last.depth) - rate.depth).norm(),
                  1e-5 * rate.depth.norm());
        EXPECT_LE((slope(start.flux, later.flux, last.flux) - rate.flux).norm(),
                  1e-5 * rate.flux.norm());
    }
}

TEST(ShallowWaterErrors, name_the_cell_and_the_dimension) {
    const auto mesh = circumcentric(grid(2, 2));
    const ShallowWater water(mesh);
    EXPECT_REFUSED(water.rate({Vector{{1, 1, 0, 1}}, Vector::Zero(12)}), "depth", "water", "cell 2",
                   "0");
    EXPECT_REFUSED(ShallowWater{circumcentric(kuhn(3, 1))}, "shallow water", "dimension 3",
                   "surface");
}

TEST(ShallowWaterErrors, name_the_number_that_is_none) {
    const auto mesh = circumcentric(grid(2, 2));
    const double nan = std::nan(""), infinite = INFINITY;
    for (const double gravity : {nan, -1.0, 0.0, infinite})
        EXPECT_REFUSED((ShallowWater{mesh, {.gravity = gravity}}), "gravity",
                       fmt::format("{}", gravity));
    EXPECT_REFUSED((ShallowWater{mesh, {.rotation = Vector::Constant(9, nan)}}), "frame",
                   "value 0 is nan");
    EXPECT_REFUSED((ShallowWater{mesh, {.bottom = Vector{{0, 0, infinite, 0}}}}), "bottom",
                   "value 2 is inf");
    const ShallowWater water(mesh);
    EXPECT_REFUSED(water.rate({Vector{{1, infinite, 1, 1}}, Vector::Zero(12)}), "depth", "cell 1",
                   "inf");
    EXPECT_REFUSED(water.rate({Vector::Ones(4), Vector::Constant(12, nan)}), "fluxes",
                   "value 0 is nan");
}

} // namespace polydec::test::in_shallow_water
