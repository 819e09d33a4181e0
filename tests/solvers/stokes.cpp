// SPDX-License-Identifier: MIT
#include "tests/solvers/cases.h"

namespace polydec::test::in_stokes {

/// Without divergence, and - Laplace u = u; the pressure is x_0 x_1.
Vector velocity(const Vector& x) {
    Vector u(x.size());
    for (Index i = 0; i < x.size(); ++i)
        u[i] = std::sin(1.5 * x[(i + 1) % x.size()] + 0.3 + i);
    return u;
}

/// delta of its flux: the curl, a number in the plane.
Vector vorticity(const Vector& x) {
    const auto slope = [&](Index i) { // of u_i, in the direction that it changes in
        return 1.5 * std::cos(1.5 * x[(i + 1) % x.size()] + 0.3 + i);
    };
    if (x.size() == 2)
        return Vector{{slope(1) - slope(0)}};
    return Vector{{-slope(1), -slope(2), -slope(0)}};
}

/// Which facets of the unit cube are not walls without slip.
struct Openings {
    bool left_open, bottom_slips;

    std::vector<FlowBoundary> of(const Points& facets) const {
        std::vector<FlowBoundary> result;
        for (Index f = 0; f < facets.rows(); ++f)
            result.push_back(left_open && facets(f, 0) < 1e-9      ? FlowBoundary::pressure
                             : bottom_slips && facets(f, 1) < 1e-9 ? FlowBoundary::free_slip
                                                                   : FlowBoundary::no_slip);
        return result;
    }
};

constexpr Openings openings[] = {{false, false}, {true, false}, {false, true}, {true, true}};

/// Of the flux, relative, of the pressure, and what flows out of a cell. `turned` is a factor at
/// what is known along walls, 1 for the solution.
Eigen::Vector3d errors(const Discretization& mesh, const Openings& open, double turned = 1) {
    constexpr double nu = 0.7;
    const int n = mesh.dimension();
    const StokesSolver solver(mesh, {.viscosity = nu, .facets = open.of(facet_sites(mesh))});
    const auto exact = de_rham(mesh, n - 1, flux_form(velocity));
    const auto force = de_rham(mesh, n - 1, flux_form([&](const Vector& x) -> Vector {
                                   Vector f = 2.25 * nu * velocity(x);
                                   f[0] += x[1];
                                   f[1] += x[0];
                                   return f;
                               }));
    // star of the flux
    const auto along = boundary_de_rham(mesh, 1, circulation_form([&](const Vector& x) -> Vector {
                                            return (n % 2 == 0 ? -1 : 1) * turned * velocity(x);
                                        }));
    const auto turns =
        de_rham(mesh, n - 2, [&](const Vector& x) -> Vector { return turned * vorticity(x); });
    const auto pressures = [](const Points& at) {
        return Vector(at.col(0).cwiseProduct(at.col(1)));
    };
    const auto flow = solver.solve(force, {.through = exact.values,
                                           .along = along,
                                           .vorticity = turns.values,
                                           .pressure = pressures(facet_sites(mesh))});
    Vector p = pressures(dual_sites(mesh));
    const Vector& volumes = mesh.volumes().primal(n);
    if (!open.left_open)
        p.array() -= p.dot(volumes) / volumes.sum();
    const SparseMatrix star_of_flux = mesh.stars()[n - 1].matrix();
    const Vector e = flow.flux.values - exact.values;
    return {std::sqrt(e.dot(star_of_flux * e) / exact.values.dot(star_of_flux * exact.values)),
            std::sqrt(volumes.dot((flow.pressure.values - p).cwiseAbs2())),
            d(mesh.complex(), flow.flux).values.cwiseAbs().maxCoeff()};
}

struct Row : Case {
    double flux_order, pressure_order; ///< at least
    double less = 0;                   ///< of both, where not all walls are without slip
};

class Flows : public testing::TestWithParam<Row> {};

TEST_P(Flows, converge_and_lose_nothing) {
    const Row& row = GetParam();
    const auto& fine = row.mesh(row.fine);
    for (const Openings& open : openings) {
        SCOPED_TRACE(testing::Message() << open.left_open << open.bottom_slips);
        const Vector found = orders(
            row, [&](const Discretization& mesh) -> Vector { return errors(mesh, open).head(2); });
        const double lower = open.left_open || open.bottom_slips ? row.less : 0;
        EXPECT_GE(found[0], row.flux_order - lower);
        EXPECT_GE(found[1], row.pressure_order - lower);
        EXPECT_LE(errors(fine, open)[2], 1e-14);
        EXPECT_GT(errors(fine, open, 2)[0], 0.1) << "with twice of what there is at the walls";
    }
}

// Vorticity on walls is what tangential velocities tell of it: first order there, which costs the
// pressure half an order or a whole one.
INSTANTIATE_TEST_SUITE_P(
    Stokes, Flows,
    testing::Values(
        Row{{"squares"}, 1.8, 1.6}, Row{{"squares", 8, 16, StarKind::galerkin}, 1.9, 1.1, 0.15},
        Row{{"hexagons"}, 1.9, 1.8}, Row{{"hexagons", 8, 16, StarKind::galerkin}, 1.0, 0.6, 0.2},
        Row{{"triangles"}, 1.1, 0.6}, Row{{"triangles", 8, 16, StarKind::galerkin}, 1.4, 0.9, 0.2},
        Row{{"cubes", 4, 8}, 1.5, 1.3}, Row{{"bcc", 2, 4, StarKind::galerkin}, 1.3, 0.9}),
    name_of<Row>);

/// Walls of all kinds meet: at the left the pressure is known where facets have duals, at the
/// bottom the flow slips.
TEST(Flows, have_the_vorticity_that_flows_in_time_have) {
    for (const Case& on : {Case{"squares"}, Case{"hexagons"}, Case{"triangles"},
                           Case{"hexagons", 8, 16, StarKind::galerkin}, Case{"cubes", 4}}) {
        SCOPED_TRACE(on);
        const auto& mesh = on.mesh(on.coarse);
        const int n = mesh.dimension();
        const bool has_duals = mesh.stars()[n - 1].zeros().empty();
        const auto facets = Openings{has_duals, true}.of(facet_sites(mesh));
        const auto slow = StokesSolver(mesh, {.facets = facets})
                              .solve({Side::primal, n - 1, random_vector(mesh.size(n - 1), 1)});
        const Vector z = IncompressibleFlow(mesh, {.facets = facets}).vorticity(slow.flux.values);
        EXPECT_LE((z - slow.vorticity.values).norm(), 1e-10 * z.norm());
    }
}

/// Through a strip of the length 2 and the width 1, whose ends are open, for this difference of
/// pressures: what flows, all but 1/12 of the difference by length and viscosity.
double channel_error(const std::string& shape, int cells, double difference) {
    Mesh strip = shape == "quads" ? grid(2 * cells, cells) : well_centered(cells / 2);
    strip.points.col(0) *= shape == "quads" ? 2 : 1;
    const auto mesh = circumcentric(strip);
    const double length = mesh.points().col(0).maxCoeff();
    const Points facets = facet_sites(mesh);
    const auto at_end = [&](Index f) {
        return facets(f, 0) < 1e-9 || facets(f, 0) > length - 1e-9;
    };
    StokesOptions options{.viscosity = 0.5};
    for (Index f = 0; f < facets.rows(); ++f)
        options.facets.push_back(at_end(f) ? FlowBoundary::pressure : FlowBoundary::no_slip);
    const Vector pressure = (length - facets.col(0).array()) / length * difference;
    const auto flow =
        StokesSolver(mesh, options)
            .solve({Side::primal, 1, Vector::Zero(facets.rows())}, {.pressure = pressure});
    double through = 0;
    for (Index f = 0; f < facets.rows(); ++f)
        if (mesh.complex().coface_counts(1)[f] == 1 && at_end(f))
            through += std::abs(flow.flux.values[f]) / 2;
    return std::abs(through - 1 / (12 * 0.5 * length));
}

// The twin: with twice the pressure twice as much flows.
TEST(Channel, lets_through_what_the_pressure_drives) {
    for (const char* shape : {"quads", "triangles"}) {
        const double coarse = channel_error(shape, 8, 1), fine = channel_error(shape, 16, 1);
        EXPECT_GE(std::log2(coarse / fine), 1.7) << shape;
        EXPECT_LE(fine, 2e-3) << shape;
        EXPECT_GT(channel_error(shape, 16, 2), 0.05) << shape;
    }
}

TEST(Channel, whose_walls_hold_nothing_back_is_refused) {
    const auto mesh = circumcentric(grid(4, 4));
    const Points facets = facet_sites(mesh);
    StokesOptions options;
    for (Index f = 0; f < facets.rows(); ++f)
        options.facets.push_back(std::abs(facets(f, 0) - 0.5) > 0.49 ? FlowBoundary::pressure
                                                                     : FlowBoundary::free_slip);
    EXPECT_REFUSED(StokesSolver(mesh, options), "1 flows", "holes", "wall");
    std::replace(options.facets.begin(), options.facets.end(), FlowBoundary::pressure,
                 FlowBoundary::open);
    EXPECT_REFUSED(StokesSolver(mesh, options), "facet", "open", "does not determine",
                   "FlowBoundary::pressure");
    for (auto& kind : options.facets)
        kind = FlowBoundary::free_slip;
    EXPECT_NO_THROW(StokesSolver(mesh, options));
    EXPECT_NO_THROW(StokesSolver(circumcentric(icosphere(2))));
    EXPECT_REFUSED(StokesSolver(circumcentric(torus(12, 8))), "2 flows", "holes");
}

// The twin: the same where the other half of the flow is let out.
TEST(StokesErrors, tell_what_does_not_balance_in_one_of_two_components) {
    Mesh other = grid(3, 3);
    other.points.col(0).array() += 5;
    const auto mesh = circumcentric(united(grid(4, 4), other));
    const StokesSolver solver(mesh);
    const Cochain still{Side::primal, 1, Vector::Zero(mesh.complex().size(1))};
    const auto fluxes = [&](double left, double right) {
        return de_rham(mesh, 1, flux_form([=](const Vector& x) -> Vector {
                           return Vector{{x[0] < 0.01 ? left : x[0] > 3 ? 0 : right, 0}};
                       }))
            .values;
    };
    EXPECT_REFUSED(solver.solve(still, {.through = fluxes(1, 0)}), "net outflow", "1", "expected 0",
                   "open facet");
    const auto flow = solver.solve(still, {.through = fluxes(1, 1)});
    EXPECT_LE(d(mesh.complex(), flow.flux).values.cwiseAbs().maxCoeff(), 1e-13);
    EXPECT_NEAR(flow.pressure.values.tail(9).norm(), 0, 1e-12) << "where nothing flows";
    EXPECT_NEAR(flow.pressure.values.head(16).sum(), 0, 1e-10) << "its mean is 0 by itself";
}

TEST(StokesErrors, name_what_does_not_fit) {
    const auto mesh = circumcentric(grid(2, 2));
    const Cochain still{Side::primal, 1, Vector::Zero(mesh.complex().size(1))};
    const StokesSolver solver(mesh);
    EXPECT_REFUSED(solver.solve({Side::primal, 0, Vector::Zero(9)}), "force", "primal 0-form",
                   "primal 1-form");
    EXPECT_REFUSED(solver.solve(still, {.through = Vector::Ones(2)}), "2 fluxes", "facets", "12");
    EXPECT_REFUSED(StokesSolver(mesh, {.viscosity = 0}), "viscosity is 0");
}

} // namespace polydec::test::in_stokes
