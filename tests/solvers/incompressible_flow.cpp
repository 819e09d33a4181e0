// SPDX-License-Identifier: MIT
#include "tests/solvers/flow_samples.h"

namespace polydec::test::in_incompressible_flow {

Vector marched(const IncompressibleFlow& equations, const Vector& w, const FlowSteps& steps,
               int count) {
    Flow flow(equations, w, steps);
    flow.advance(count);
    return flow.flux();
}

/// Any flow on a mesh.
Vector some_flow(const IncompressibleFlow& flow, unsigned seed) {
    const auto& mesh = flow.mesh();
    return flow.project(random_vector(mesh.complex().size(mesh.dimension() - 1), seed)
                            .cwiseProduct(mesh.volumes().primal(mesh.dimension() - 1)));
}

/// Surfaces and solids, closed and bounded, of quads, triangles, hexagons, cubes, octahedra.
std::vector<std::pair<std::string, Mesh>> flow_meshes() {
    return {{"quads", grid(6, 5)},           {"triangles", well_centered(4)},
            {"hexagons", hexagons(5)},       {"ring", annulus(16, 4)},
            {"sphere", icosphere(4)},        {"goldberg", goldberg(3)},
            {"uv sphere", uv_sphere(12, 8)}, {"torus", torus(16, 10)},
            {"cubes", kuhn(3, 4)},           {"octahedra", bcc(2)}};
}

TEST(Flows, keep_their_energy_without_viscosity_on_any_cells) {
    for (const auto& [name, mesh] : flow_meshes()) {
        const IncompressibleFlow flow(circumcentric(mesh));
        const Vector w = some_flow(flow, 1);
        const double dt = 0.3 * flow.exchange_time(w), before = flow.energy(w);
        const Vector after = marched(flow, w, {.time_step = dt}, 20);
        EXPECT_NEAR(flow.energy(after) / before, 1, 1e-11) << name;
        EXPECT_GT(flow_error(flow, after, w), 1e-3) << name << ": nothing moves";
        EXPECT_LE(flow.divergence(after), 1e-12) << name;
        // explicit steps do not keep it
        const Vector euler = w + dt * flow.rate(w);
        EXPECT_GT(std::abs(flow.energy(euler) / before - 1), 1e-6) << name;
    }
}

TEST(Flows, lose_what_friction_takes) {
    for (const auto& [name, mesh] : flow_meshes()) {
        const IncompressibleFlow flow(circumcentric(mesh), {.viscosity = 0.01});
        const Vector w = some_flow(flow, 1);
        const double dt = 0.2 * flow.exchange_time(w);
        const Vector next = marched(flow, w, {.time_step = dt}, 1);
        const double lost = flow.energy(w) - flow.energy(next);
        EXPECT_NEAR(lost / (dt * flow.dissipation((w + next) / 2)), 1, 1e-8) << name;
    }
}

/// Velocities at facets of walls that turn around the last axis.
Points turning(const Discretization& mesh) {
    Points result = cell_centers(mesh, mesh.dimension() - 1);
    const Vector x = result.col(0);
    result.col(0) = -result.col(1);
    result.col(1) = x;
    result.rightCols(result.cols() - 2).setZero();
    return result;
}

TEST(Flows, have_circulations_that_are_stars_of_vorticity_and_on_closed_surfaces_add_to_0) {
    for (const auto& [name, mesh] : flow_meshes()) {
        if (name == "octahedra") // walls cut the duals of their edges below 0
            continue;
        const auto on = circumcentric(mesh);
        const int n = on.dimension();
        const IncompressibleFlow flow(
            on,
            {.viscosity = 1, .everywhere = FlowBoundary::no_slip, .wall_velocity = turning(on)});
        const Vector w = some_flow(flow, 3), around = flow.circulations(w);
        EXPECT_CLOSE(around, on.stars()[n - 2] * flow.vorticity(w), 1e-12) << name;
        if (n == 2 && boundary_facets(on.complex()).empty())
            EXPECT_LE(std::abs(around.sum()), 1e-12 * around.cwiseAbs().sum()) << name;
    }
}

TEST(Flows, that_turn_with_their_walls_have_twice_the_area_as_circulation) {
    const auto disk = circumcentric(hexagons(12));
    const IncompressibleFlow flow(
        disk,
        {.viscosity = 1, .everywhere = FlowBoundary::no_slip, .wall_velocity = turning(disk)});
    const Vector w = flow_of(disk, [](const Vector& x) { return x.squaredNorm() / 2; });
    EXPECT_NEAR(std::abs(flow.circulations(w).sum()), 2 * disk.volumes().primal(2).sum(), 1e-12);
}

TEST(Flows, are_advanced_with_their_harmonic_part) {
    for (const auto& [name, mesh] : {std::pair("torus", torus(16, 10)), {"ring", annulus(16, 4)}}) {
        const auto on = circumcentric(mesh);
        const IncompressibleFlow flow(on);
        // forms that vanish on the boundary: nothing goes through it
        const auto inside = relative_to_boundary(on.complex());
        const Vector harmonic = inside.extend(
            1, Vector(harmonic_forms(
                          {{inside.complex, relative_stars(inside, on.stars())}, Side::primal, 1})
                          .rowwise()
                          .sum()));
        ASSERT_GT(flow.energy(harmonic), 1e-6) << name;
        EXPECT_LE(flow.vorticity(harmonic).cwiseAbs().maxCoeff(), 1e-9) << name;
        // without vorticity a flow is steady
        EXPECT_LE(std::sqrt(flow.energy(flow.rate(harmonic))), 1e-9) << name;
    }
}

TEST(Flows, on_a_turning_sphere_go_around_with_it) {
    const auto sphere = circumcentric(icosphere(8));
    const IncompressibleFlow flow(
        sphere, {.rotation = at(sphere.points(), [](const Vector& x) { return 2 * x[2]; })});
    const Vector w = flow_of(sphere, [](const Vector& x) { return x[0]; });
    // a Rossby wave of degree 1 moves by - 2 Omega m / (l (l + 1)), as fast as the frame turns
    const int steps = 40;
    const Vector after = marched(flow, w, {.time_step = pi / 2 / steps}, steps);
    const Vector east = flow_of(sphere, [](const Vector& x) { return x[1]; });
    EXPECT_LE(std::min(flow_error(flow, after, east), flow_error(flow, after, -east)), 0.02);
}

TEST(Flows, between_turning_cylinders_are_couettes) {
    std::vector<double> errors;
    for (const int n : {8, 16}) {
        const auto mesh = circumcentric(annulus(6 * n, n));
        FlowOptions options{.viscosity = 1, .everywhere = FlowBoundary::no_slip};
        options.wall_velocity = Points::Zero(mesh.complex().size(1), 2);
        const Points facets = cell_centers(mesh, 1);
        for (Index f = 0; f < facets.rows(); ++f)
            if (facets.row(f).norm() > 1.5) // the outer one turns with speed 2
                options.wall_velocity.row(f) << -facets(f, 1), facets(f, 0);
        const IncompressibleFlow flow(mesh, options);
        // a r + b / r: 0 at 1 and 2 at 2
        const Vector exact = flow_of(mesh, [](const Vector& x) {
            const double r = x.norm();
            return 4. / 3 * (r * r / 2 - std::log(r));
        });
        const Vector start = flow.project(Vector::Zero(exact.size()));
        const Vector found =
            marched(flow, start, {.time_step = 0.1, .scheme = FlowScheme::imex}, 30);
        errors.push_back(std::min(flow_error(flow, found, exact), flow_error(flow, -found, exact)));
    }
    EXPECT_LE(errors[1], 2e-3);
    EXPECT_GT(std::log2(errors[0] / errors[1]), 1.7);
}

TEST(Flows, through_a_channel_are_poiseuilles) {
    std::vector<double> errors;
    for (const int n : {8, 16}) {
        const auto mesh = circumcentric(grid(2 * n, n, 2, 1));
        const auto stream = [](const Vector& x) { return x[1] * x[1] * (3 - 2 * x[1]); };
        const Vector exact = flow_of(mesh, stream);
        const IncompressibleFlow flow(
            mesh, {.viscosity = 1, .everywhere = FlowBoundary::no_slip, .boundary_flux = exact});
        const Vector found = marched(flow, flow.project(Vector::Zero(exact.size())),
                                     {.time_step = 0.02, .scheme = FlowScheme::imex}, 30);
        errors.push_back(flow_error(flow, found, exact));
        // the pressure falls by 12 nu per length
        const Points cells = cell_centers(mesh, 2);
        const Vector p = flow.pressure(found).values;
        const auto nearest = [&](double x) {
            Index cell = 0;
            (cells.rowwise() - Eigen::RowVector2d(x, 0.5)).rowwise().norm().minCoeff(&cell);
            return cell;
        };
        const Index left = nearest(0.5), right = nearest(1.5);
        EXPECT_NEAR((p[left] - p[right]) / (cells(right, 0) - cells(left, 0)), 12, 1);
    }
    EXPECT_LE(errors[1], 5e-3);
    EXPECT_GT(std::log2(errors[0] / errors[1]), 1.7);
}

TEST(Flows, leave_through_open_boundaries_what_comes_in) {
    const auto mesh = circumcentric(grid(16, 8, 2, 1));
    const Points facets = cell_centers(mesh, 1);
    FlowOptions options{.viscosity = 0.1};
    const Vector uniform = flow_of(mesh, [](const Vector& x) { return x[1]; });
    options.boundary_flux = uniform;
    options.facets.assign(static_cast<std::size_t>(facets.rows()), FlowBoundary::free_slip);
    for (Index f = 0; f < facets.rows(); ++f)
        if (facets(f, 0) > 2 - 1e-9)
            options.facets[f] = FlowBoundary::open;
    const IncompressibleFlow flow(mesh, options);
    const Vector start = flow.project(Vector::Zero(uniform.size()));
    EXPECT_LE(flow.divergence(start), 1e-12);
    EXPECT_LE(flow_error(flow, start, uniform), 1e-10);
    const Vector w = marched(flow, start, {.time_step = 0.05, .scheme = FlowScheme::imex}, 20);
    EXPECT_LE(flow_error(flow, w, uniform), 1e-8);
}

TEST(Flows, that_walls_do_not_let_through_are_at_rest) {
    const auto mesh = discretize(grid(12, 12));
    const Points right = Eigen::RowVector2d(1, 0).replicate(mesh.size(0), 1);
    for (const double speed : {0x1p-600, 1.0, 0x1p600}) {
        const Vector given = speed * flow_of_velocity(mesh, right);
        const IncompressibleFlow flow(mesh);
        const Vector w = flow.project(given);
        EXPECT_TRUE(w.isZero(0));
        EXPECT_EQ(flow.divergence(w), 0);
        EXPECT_EACH_SAYS(warning_of_rest(given, w), {"at rest", "FlowOptions::boundary_flux"});
        const IncompressibleFlow open(mesh, {.everywhere = FlowBoundary::open});
        EXPECT_LE(((open.project(given) - given) / speed).norm(), 1e-12);
        EXPECT_TRUE(warning_of_rest(given, open.project(given)).empty());
        EXPECT_NEAR(open.relative_energy(2 * given, given), 4, 1e-12);
    }
}

/// The fastest decay by friction: Rayleigh's quotient after many powers.
double fastest_decay(const IncompressibleFlow& flow) {
    const FlowProjection projection = flow.implicit_part(0);
    Vector w = some_flow(flow, 2);
    double rate = 0;
    for (int i = 0; i < 100; ++i) {
        const Vector next = projection.solve_at_rest(flow.friction(w)).flux;
        rate = -w.dot(flow.momentum(next)) / w.dot(flow.momentum(w));
        w = next / next.norm();
    }
    return rate;
}

// The twins: shorter steps, and the other scheme, which damps them.
TEST(Flows, warn_of_friction_that_midpoints_do_not_follow) {
    for (const auto& [name, mesh] : flow_meshes())
        for (const FlowBoundary kind : {FlowBoundary::free_slip, FlowBoundary::no_slip}) {
            if (kind == FlowBoundary::no_slip && name == "octahedra")
                continue; // their duals at walls are negative
            const IncompressibleFlow flow(circumcentric(mesh),
                                          {.viscosity = 0.3, .everywhere = kind});
            const Vector w = some_flow(flow, 1);
            const double limit = 2 / fastest_decay(flow);
            const auto warned = [&](double step, FlowScheme scheme) {
                return Flow(flow, w, {.time_step = step, .scheme = scheme}).warnings();
            };
            EXPECT_EACH_SAYS(warned(1.05 * limit, FlowScheme::implicit_midpoint),
                             {"friction", "change sign", "FlowScheme::imex"})
                << name;
            EXPECT_TRUE(warned(1.05 * limit, FlowScheme::imex).empty());
            if (kind == FlowBoundary::free_slip) { // else it is an upper bound
                EXPECT_TRUE(warned(0.95 * limit, FlowScheme::implicit_midpoint).empty()) << name;
            }
            const IncompressibleFlow ideal(circumcentric(mesh), {.everywhere = kind});
            EXPECT_TRUE(Flow(ideal, w, {.time_step = 1e3 * limit}).warnings().empty());
        }
}

TEST(FlowBoundaries, are_chosen_where_marks_hold_on_the_boundary) {
    for (const auto& [name, mesh] : flow_meshes()) {
        const CellComplex complex = circumcentric(mesh).complex();
        const int n = complex.dimension();
        const auto facets = static_cast<std::size_t>(complex.size(n - 1));
        std::vector<bool> inside, on_boundary;
        for (const Index count : complex.coface_counts(n - 1)) {
            inside.push_back(count == 2);
            on_boundary.push_back(count == 1);
        }
        const auto chosen = [&](const std::vector<bool>& marks, const std::vector<bool>& others) {
            std::vector<FlowFacets> given{{FlowBoundary::no_slip, marks, "walls"},
                                          {FlowBoundary::open, others, "ends"}};
            std::erase_if(given, [](const FlowFacets& each) { return each.marks.empty(); });
            return flow_boundary(complex, given);
        };
        const std::vector<bool> none{}, all{true}, nowhere(facets, false);
        EXPECT_EQ(chosen(none, none), std::vector(facets, FlowBoundary::free_slip)) << name;
        EXPECT_EQ(chosen(all, all), std::vector(facets, FlowBoundary::open)) << name;
        if (boundary_facets(complex).empty()) {
            EXPECT_EQ(chosen(nowhere, none), chosen(none, none)) << name;
            continue;
        }
        const auto ends = chosen(all, on_boundary);
        for (std::size_t f = 0; f < facets; ++f)
            EXPECT_EQ(ends[f], on_boundary[f] ? FlowBoundary::open : FlowBoundary::no_slip) << name;
        for (const auto& marks : {inside, nowhere, std::vector{false}}) {
            EXPECT_REFUSED(chosen(marks, none), "walls", "none of the", "boundary");
            EXPECT_REFUSED(chosen(all, marks), "ends", "none of the", "boundary");
        }
        EXPECT_REFUSED(chosen({true, false}, none), "2 marks", "facets");
    }
}

TEST(FlowErrors, name_what_is_wrong) {
    const auto mesh = circumcentric(grid(4, 4));
    const auto refused = [&](const FlowOptions& options) {
        return refusal([&] { IncompressibleFlow(mesh, options); });
    };
    EXPECT_SAYS(refused({.viscosity = -1}), "viscosity", "-1");
    EXPECT_SAYS(refused({.facets = {FlowBoundary::open}}), "1 conditions", "facets", "40");
    Vector flux = Vector::Zero(40);
    const Points facets = cell_centers(mesh, 1);
    for (Index f = 0; f < 40; ++f)
        if (facets(f, 0) == 0 && facets(f, 1) < 0.2)
            flux[f] = 0.5;
    EXPECT_SAYS(refused({.boundary_flux = flux}), "boundary", "-0.5");
    EXPECT_SAYS(refused({.everywhere = FlowBoundary::open, .boundary_flux = flux}),
                "FlowOptions::boundary_flux", "none of the 16", "facet");
    for (const FlowBoundary kind : {FlowBoundary::open, FlowBoundary::free_slip})
        EXPECT_SAYS(refused({.everywhere = kind, .wall_velocity = Points::Ones(40, 2)}),
                    "FlowOptions::wall_velocity", "none of the 16", "no-slip facet");
    EXPECT_SAYS(refused({.boundary_flux = flux, .wall_velocity = Points::Ones(40, 2)}),
                "FlowOptions::wall_velocity", "none of the 16", "no-slip facet");
    const IncompressibleFlow flow(mesh);
    const Vector w = some_flow(flow, 1);
    EXPECT_REFUSED(Flow(flow, w, {.time_step = 0}), "time step is 0");
    EXPECT_REFUSED(Flow(flow, Vector(3), {.time_step = 1}), "3 fluxes");
    for (const double tolerance : {-1.0, std::nan("")})
        EXPECT_REFUSED(Flow(flow, w, {.time_step = 1, .tolerance = tolerance}),
                       "FlowSteps::tolerance");
    for (const int passes : {0, -3})
        EXPECT_REFUSED(Flow(flow, w, {.time_step = 1, .most_passes = passes}),
                       "FlowSteps::most_passes", std::to_string(passes));
    Vector broken = w;
    broken[7] = std::nan("");
    EXPECT_REFUSED(Flow(flow, broken, {.time_step = 1}), "fluxes", "value 7 is nan");
    EXPECT_REFUSED(flow.divergence(broken), "fluxes", "value 7 is nan");
    EXPECT_REFUSED(flow.exchange_time(broken), "fluxes", "value 7 is nan");
    EXPECT_REFUSED(flow.project(broken), "fluxes", "value 7 is nan");
    Flow rash(flow, w, {.time_step = 50 * flow.exchange_time(w)});
    EXPECT_THROW(rash.advance(), SolverFailure);
    EXPECT_EQ(rash.flux(), w);
}

} // namespace polydec::test::in_incompressible_flow
