// SPDX-License-Identifier: MIT
#include "dec/metric/subsets.h"
#include "tests/solvers/cases.h"

namespace polydec::test::in_evolution {

using std::numbers::pi;

Cochain on(const Discretization& mesh, Side side, int degree, const SmoothForm& form) {
    return side == Side::primal ? de_rham(mesh, degree, form) : dual_de_rham(mesh, degree, form);
}

/// An eigenform of Delta on the unit box under the built-in conditions of a side, to the eigenvalue
/// n pi^2: at dx_I a product of sines in the directions in which it vanishes at the walls, and of
/// cosines in the others.
SmoothForm eigenform(int n, Side side, int degree) {
    return [=](const Vector& x) {
        const auto subsets = polydec::subsets(n, degree);
        Vector result(subsets.size());
        for (std::size_t i = 0; i < subsets.size(); ++i) {
            result[i] = 1 + 0.5 * i;
            for (int axis = 0; axis < n; ++axis) {
                const bool is_in = std::count(subsets[i].begin(), subsets[i].end(), axis) > 0;
                const bool is_sine = is_in == (side == Side::primal);
                result[i] *= is_sine ? std::sin(pi * x[axis]) : std::cos(pi * x[axis]);
            }
        }
        return result;
    };
}

/// Heat with the source that makes cos(t) times the eigenform its solution: the error at the time
/// 1/2 in the norm of the solution at the beginning. `terms` is n, or else the source is another.
double error_of_heat(const Discretization& mesh, Side side, int degree, double terms,
                     double conductivity = 0.3) {
    const Cochain u = on(mesh, side, degree, eigenform(mesh.dimension(), side, degree));
    const double decay = conductivity * terms * pi * pi;
    Evolution heat(
        {{.space = {mesh, u.side, u.degree}, .start = u.values, .diffusion = conductivity}},
        [&](double t, const std::vector<Cochain>&) {
            return std::vector{Vector((decay * std::cos(t) - std::sin(t)) * u.values)};
        },
        {.steps = {.relative_tolerance = 1e-7}});
    heat.march(0.5);
    return norm(mesh, heat.form(0) - std::cos(0.5) * u) / norm(mesh, u);
}

double order_of_heat(const Case& cells, Side side, int degree, double more_terms = 0) {
    return order(cells, [&](const Discretization& mesh) {
        return error_of_heat(mesh, side, degree, mesh.dimension() + more_terms);
    });
}

// The twin: with the source of another solution it does not converge.
TEST(evolution, heat_with_a_source_converges_in_space_in_every_degree_and_on_both_sides) {
    for (const Case& cells : {Case{"interval"}, Case{"squares"}, Case{"cubes", 3, 6}})
        for_all_forms(cells.dimension(), [&](Side side, int degree) {
            EXPECT_NEAR(order_of_heat(cells, side, degree), 2, 0.2) << cells;
            EXPECT_LT(order_of_heat({cells.pattern, 3, 6}, side, degree, 1), 0.5) << cells;
        });
}

// The tetrahedra at the walls of their lattice have negative duals, so that Delta of dual 0-forms
// is not semidefinite.
TEST(evolution, heat_with_a_source_converges_on_polygons_and_polytopes) {
    for (const Case& cells :
         {Case{"triangles"}, Case{"hexagons"}, Case{"bcc", 3, 6}, Case{"fcc", 3, 6}})
        for (const Side side : sides)
            if (side == Side::primal || cells.pattern != "bcc") {
                EXPECT_NEAR(order_of_heat(cells, side, 0), 2, 0.3) << cells << name(side);
            }
}

/// Diffusion against the reaction u (1 + sin t - u), up to the time 1.
Cochain competing(const Discretization& mesh, const Cochain& start, Index steps) {
    Evolution run(
        {{.space = {mesh, start.side, start.degree}, .start = start.values, .diffusion = 0.1}},
        [](double t, const std::vector<Cochain>& now) {
            const auto u = now[0].values.array();
            return std::vector{Vector(u * (1 + std::sin(t) - u))};
        },
        {.steps = {.fixed_step = 1. / steps}});
    run.march(1);
    return run.form(0);
}

TEST(evolution, steps_are_of_fourth_order_where_diffusion_and_reaction_compete) {
    for (const auto& mesh : {circumcentric(kuhn(2, 6)), circumcentric(kuhn(3, 3))}) {
        const Cochain start =
            de_rham(mesh, 0,
                    function_form([](const Vector& x) { return 0.5 + 0.2 * std::cos(pi * x[0]); }));
        const Cochain end = competing(mesh, start, 256);
        const auto error = [&](Index steps) {
            return norm(mesh, competing(mesh, start, steps) - end);
        };
        EXPECT_NEAR(std::log2(error(8) / error(16)), 4, 0.4);
    }
}

// The twin: without the values on the boundary they do not stay constant.
TEST(evolution, constant_forms_grow_with_their_values_on_the_boundary) {
    const BoundaryConditions essential{BoundaryCondition::essential};
    for (const char* pattern : {"interval", "squares", "cubes"}) {
        const auto& mesh = Case{pattern}.mesh(4);
        const int n = mesh.dimension();
        for_all_forms(n - 1, [&](Side side, int degree) {
            const SmoothForm constant =
                constant_form(Vector::LinSpaced(coefficients(n, degree), 1, 2));
            const Cochain u = on(mesh, side, degree, constant);
            const Vector data =
                side == Side::primal ? u.values : boundary_de_rham(mesh, degree, constant);
            const auto growth = [](double t) { return 1 + t * t; };
            const auto defect = [&](bool has_data) {
                Unknown unknown{{mesh, side, degree, essential}, u.values, 1};
                if (has_data)
                    unknown.boundary = [&](double t) {
                        return BoundaryForms{.values = growth(t) * data};
                    };
                Evolution run({unknown}, [&](double t, const std::vector<Cochain>&) {
                    return std::vector{Vector(2 * t * u.values)};
                });
                run.march(1);
                return norm(mesh, run.form(0) - growth(1) * u) / norm(mesh, u);
            };
            EXPECT_LE(defect(true), 1e-4);
            EXPECT_GT(defect(false), 0.1);
        });
    }
}

/// Rounding in long steps is no growth.
TEST(evolution, diffusion_goes_on_for_any_time) {
    for (const Mesh& input : {goldberg(4), kuhn(3, 3), grid(4, 4)}) {
        const auto mesh = discretize(input);
        const Unknown built_in{.space = {mesh, Side::primal, 0},
                               .start = Vector::LinSpaced(mesh.size(0), 0, 1),
                               .diffusion = 1};
        Unknown own = built_in;
        own.stiff =
            std::make_shared<Diffusion>(star(mesh, 0), symmetric_laplacian(mesh, 0), Side::primal);
        for (const Unknown& unknown : {built_in, own}) {
            Evolution heat({unknown});
            EXPECT_NO_THROW(heat.march(1e8));
            const Vector end = heat.form(0).values;
            EXPECT_LE(end.maxCoeff() - end.minCoeff(), 1e-6);
        }
    }
}

/// Gray and Scott's reaction, with u and v on either side.
Evolution gray_scott(const Discretization& mesh, const std::string& integrator, Side side,
                     double fixed_step = 0) {
    const Index count = mesh.complex().size(side == Side::primal ? 0 : mesh.dimension());
    const Cochain u{side, 0, Vector::Ones(count)};
    Cochain v{side, 0, Vector::Zero(count)};
    v.values.head(count / 4).setConstant(0.5);
    const FormSpace space(mesh, side, 0);
    return {{{space, u.values, 2e-3}, {space, v.values, 1e-3}},
            [](double, const std::vector<Cochain>& now) {
                const auto U = now[0].values.array(), V = now[1].values.array();
                return std::vector<Vector>{Vector(-U * V * V + 0.04 * (1 - U)),
                                           Vector(U * V * V - 0.1 * V)};
            },
            {.integrator = integrator,
             .steps = {.relative_tolerance = 1e-6, .fixed_step = fixed_step}}};
}

TEST(evolution, all_integrators_give_the_same_forms) {
    const auto mesh = circumcentric(uv_sphere(8, 6));
    for (const Side side : sides) {
        auto reference = gray_scott(mesh, "runge-kutta", side);
        reference.march(10);
        for (const auto& engine : engines()) {
            if (engine.kind != EngineKind::integrator || !engine.available)
                continue;
            const bool chooses = refusal([&] { make_integrator(engine.name); }) == "accepted";
            auto run = gray_scott(mesh, engine.name, side, chooses ? 0 : 0.01);
            run.march(10);
            for (const std::size_t i : {0, 1})
                EXPECT_LE(norm(mesh, run.form(i) - reference.form(i)), 1e-3) << engine.name;
        }
    }
}

/// Integrators that are there and choose their steps.
std::vector<std::string> choosing_integrators() {
    std::vector<std::string> names;
    for (const auto& engine : engines())
        if (engine.kind == EngineKind::integrator && engine.available &&
            refusal([&] { make_integrator(engine.name); }) == "accepted")
            names.push_back(engine.name);
    return names;
}

// A substance in another unit is followed as well. The twin: not with one absolute tolerance.
TEST(evolution, unknowns_have_units_of_their_own) {
    const auto mesh = circumcentric(uv_sphere(8, 6));
    const FormSpace space(mesh, Side::primal, 0);
    const Vector start = Vector::LinSpaced(mesh.size(0), 1, 2);
    for (const auto& engine : choosing_integrators()) {
        const auto end_of = [&](double unit, std::optional<double> absolute) {
            Evolution run({{space, start, 1e-2}, {space, unit * start, 1e-2}},
                          [=](double, const std::vector<Cochain>& now) {
                              const Vector &u = now[0].values, &v = now[1].values;
                              return std::vector<Vector>{Vector(-v / unit), Vector(unit * u)};
                          },
                          {.integrator = engine, .steps = {.absolute_tolerance = absolute}});
            run.march(5);
            return Vector(run.form(1).values / unit);
        };
        for (const double unit : {0x1p-40, 0x1p40})
            EXPECT_EQ(end_of(unit, {}), end_of(1, {})) << engine;
        EXPECT_NE(end_of(0x1p-40, 1e-8), end_of(1, 1e-8)) << engine;
    }
}

// The twin: without the integrator's memory the bits are others.
TEST(evolution, a_run_that_is_resumed_ends_in_the_same_bits) {
    const auto mesh = circumcentric(uv_sphere(8, 6));
    auto whole = gray_scott(mesh, "runge-kutta", Side::primal);
    std::vector<std::vector<Vector>> states;
    march(whole, {1, 2.5, 4}, {.show = [&](const auto& now) { states.push_back(now.state()); }});
    const auto end_of = [&](std::vector<Vector> state) {
        auto rest = gray_scott(mesh, "runge-kutta", Side::primal);
        rest.resume(1, state);
        march(rest, {2.5, 4});
        return rest.state();
    };
    EXPECT_EQ(end_of(states[0]), states[2]);
    EXPECT_NE(end_of({states[0][0], Vector()}), states[2]);
    EXPECT_THROW(whole.resume(1, {states[0][0]}), InvalidInput);
}

TEST(evolution, a_march_stops_where_a_form_has_cooled_to_a_half) {
    const auto mesh = circumcentric(kuhn(2, 16));
    const Cochain u = dual_de_rham(mesh, 0, eigenform(2, Side::dual, 0));
    Evolution heat({{.space = {mesh, u.side, u.degree}, .start = u.values, .diffusion = 1}}, {},
                   {.steps = {.relative_tolerance = 1e-8},
                    .event = [&](double, const std::vector<Cochain>& now) {
                        return inner_product(mesh, now[0], u) / inner_product(mesh, u, u) - 0.5;
                    }});
    int shown = 0;
    EXPECT_EQ(march(heat, {0.01, 1, 2}, {.show = [&](const auto&) { ++shown; }}),
              Arrival::at_event);
    EXPECT_EQ(shown, 2);
    EXPECT_NEAR(heat.time(), std::log(2.0) / (2 * pi * pi), 2e-4);
}

TEST(evolution, a_stiffness_of_ones_own_does_what_diffusion_does) {
    const auto mesh = circumcentric(kuhn(2, 5));
    const auto own = std::make_shared<Diffusion>(star(mesh, 0), 0.3 * symmetric_laplacian(mesh, 0),
                                                 Side::primal);
    const Cochain start = de_rham(mesh, 0, eigenform(2, Side::primal, 0));
    Evolution a({{.space = {mesh, start.side, start.degree}, .start = start.values, .stiff = own}});
    Evolution b(
        {{.space = {mesh, start.side, start.degree}, .start = start.values, .diffusion = 0.3}});
    a.march(0.2);
    b.march(0.2);
    EXPECT_LE(norm(mesh, a.form(0) - b.form(0)), 1e-12);
}

// The twin: the same reaction at half the pace.
TEST(evolution, reactions_keep_their_pace_beside_diffusion_of_any_strength) {
    for (const auto& [size, diffusion] : {std::pair{1e-80, 1e-309},
                                          {1e-80, 1e-160},
                                          {1.0, 1e-309},
                                          {1.0, 1e-100},
                                          {1.0, 1e100},
                                          {1e80, 1e-100},
                                          {1e80, 1.0},
                                          {1e80, 1e100}})
        for (const auto& engine : choosing_integrators()) {
            Mesh input = grid(2, 2);
            input.points *= size;
            const auto mesh = discretize(input);
            const Vector ones = Vector::Ones(mesh.size(0));
            const auto end_of = [&, nu = diffusion](double pace) {
                Evolution run({{.space = {mesh, Side::primal, 0}, .start = ones, .diffusion = nu}},
                              [pace](double, const std::vector<Cochain>& now) {
                                  return std::vector{Vector(-pace * now[0].values)};
                              },
                              {.integrator = engine});
                run.march(1);
                EXPECT_EQ(run.time(), 1);
                return run.form(0).values.maxCoeff();
            };
            EXPECT_NEAR(end_of(1), std::exp(-1), 1e-4) << size << ' ' << diffusion << engine;
            EXPECT_GT(end_of(0.5), std::exp(-1) + 0.1);
        }
}

TEST(evolution, runs_that_share_a_stiff_part_do_not_disturb_each_other) {
    const auto mesh = circumcentric(kuhn(2, 5));
    const FormSpace space(mesh, Side::primal, 0);
    const Vector start = de_rham(mesh, 0, eigenform(2, Side::primal, 0)).values;
    const auto own = [&] { return std::make_shared<const Diffusion>(space, 0.3); };
    const auto run_of = [&](const std::shared_ptr<const Diffusion>& stiff, double step) {
        return Evolution({{.space = space, .start = start, .stiff = stiff}}, {},
                         {.integrator = "backward-euler", .steps = {.fixed_step = step}});
    };
    const auto shared = own();
    Evolution a = run_of(shared, 0.01), b = run_of(shared, 0.02);
    Evolution alone = run_of(own(), 0.01), twin = run_of(own(), 0.02);
    for (const double time : {0.02, 0.04, 0.08})
        for (Evolution* run : {&a, &b, &alone, &twin})
            run->march(time);
    EXPECT_EQ(a.form(0).values, alone.form(0).values);
    EXPECT_EQ(b.form(0).values, twin.form(0).values);
    EXPECT_NE(alone.form(0).values, twin.form(0).values);
}

TEST(evolution, what_does_not_fit_is_refused_by_its_number) {
    const auto mesh = circumcentric(kuhn(2, 2));
    const FormSpace space(mesh, Side::primal, 0);
    const Vector u = Vector::Ones(9);
    EXPECT_THROW(Evolution({{space, Vector::Ones(8)}}), InvalidInput);
    EXPECT_THROW(Evolution({{space, u, -1}}), InvalidInput);
    std::vector<Unknown> unknowns(2, {space, u});
    unknowns[1].boundary = [](double) { return BoundaryForms{}; };
    EXPECT_REFUSED(Evolution{unknowns}, "unknown 1", "boundary", "diffusion");
    const auto other = std::make_shared<Diffusion>(FormSpace(mesh, Side::dual, 0));
    EXPECT_REFUSED(Evolution({{.space = space, .start = u, .stiff = other}}), "unknown 0", "stiff",
                   "dual 0-forms", "primal 0-form");
    for (const int size : {1, 3, 4}) {
        const auto cells = circumcentric(kuhn(2, size));
        const FormSpace all(cells, Side::primal, 0);
        const FormSpace inside(cells, Side::primal, 0, {BoundaryCondition::essential});
        for (const auto& stiff :
             {std::make_shared<Diffusion>(star(cells, 0), symmetric_laplacian(cells, 0),
                                          Side::primal),
              std::make_shared<Diffusion>(all), std::make_shared<Diffusion>(inside)})
            EXPECT_REFUSED(Evolution({{.space = space, .start = u, .stiff = stiff}}), "unknown 0",
                           "stiff", std::to_string(cells.size(0)), "9");
    }
    Evolution short_rates({{space, u}}, [](double, const std::vector<Cochain>&) {
        return std::vector{Vector(Vector::Ones(3))};
    });
    EXPECT_REFUSED(short_rates.march(1), "reaction", "3 rates", "unknown 0", "9");
    Evolution few_rates({{space, u}},
                        [](double, const std::vector<Cochain>&) { return std::vector<Vector>{}; });
    EXPECT_THROW(few_rates.march(1), InvalidInput);
}

} // namespace polydec::test::in_evolution
