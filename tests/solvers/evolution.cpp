// SPDX-License-Identifier: MIT
#include "solvers/evolution.h"

#include "backends/registry.h"
#include "base/errors.h"
#include "dec/fields/de_rham.h"
#include "dec/forms/derivative.h"
#include "dec/metric/subsets.h"
#include "dec/operators.h"
#include "meshes/generate.h"
#include "solvers/heat.h"
#include "tests/support/circumcentric.h"
#include "tests/support/families.h"
#include "tests/support/refusal.h"
#include "tests/support/says.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace polydec::test::in_evolution {
namespace {

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
    Evolution heat(mesh, {{.start = u, .diffusion = conductivity}},
                   [&](double t, const std::vector<Cochain>&) {
                       return std::vector{Vector((decay * std::cos(t) - std::sin(t)) * u.values)};
                   },
                   {.steps = {.relative_tolerance = 1e-7}});
    heat.march(0.5);
    return norm(mesh, heat.form(0) - std::cos(0.5) * u) / norm(mesh, u);
}

double order_of_heat(const std::function<Mesh(int)>& make, int cells, Side side, int degree,
                     double more_terms = 0) {
    const auto error = [&](int count) {
        const auto mesh = circumcentric(make(count));
        return error_of_heat(mesh, side, degree, mesh.dimension() + more_terms);
    };
    return std::log2(error(cells) / error(2 * cells));
}

// The twin: with the source of another solution it does not converge.
TEST(evolution, heat_with_a_source_converges_in_space_in_every_degree_and_on_both_sides) {
    for (const int n : {1, 2, 3})
        for (const Side side : {Side::primal, Side::dual})
            for (int degree = 0; degree <= n; ++degree) {
                const auto cubes = [n](int cells) { return kuhn(n, cells); };
                EXPECT_NEAR(order_of_heat(cubes, n < 3 ? 8 : 5, side, degree), 2, 0.2)
                    << n << name(side) << degree;
                EXPECT_LT(order_of_heat(cubes, 4, side, degree, 1), 0.5);
            }
}

TEST(evolution, heat_with_a_source_converges_on_polygons_and_polytopes) {
    struct Family {
        const char* name;
        std::function<Mesh(int)> make;
        int cells;
    };
    const Family families[] = {{"acute triangles", well_centered, 8},
                               {"hexagons", hexagons, 8},
                               {"tetrahedra", [](int cells) { return bcc(cells); }, 4},
                               {"octahedra", [](int cells) { return fcc(cells); }, 4}};
    // the tetrahedra at the walls of that lattice have negative duals, so that Delta of dual
    // 0-forms is not semidefinite
    for (const auto& [kind, make, cells] : families)
        for (const Side side : {Side::primal, Side::dual}) {
            if (side == Side::dual && std::string(kind) == "tetrahedra")
                continue;
            EXPECT_NEAR(order_of_heat(make, cells, side, 0), 2, 0.3) << kind << name(side);
        }
}

double error_after(const Discretization& mesh, const Cochain& start, Index steps,
                   const Cochain& end) {
    Evolution run(mesh, {{.start = start, .diffusion = 0.1}},
                  [](double t, const std::vector<Cochain>& now) {
                      const auto u = now[0].values.array();
                      return std::vector{Vector(u * (1 + std::sin(t) - u))};
                  },
                  {.steps = {.fixed_step = 1. / steps}});
    run.march(1);
    return norm(mesh, run.form(0) - end);
}

TEST(evolution, steps_are_of_fourth_order_where_diffusion_and_reaction_compete) {
    for (const auto& mesh : {circumcentric(kuhn(2, 6)), circumcentric(kuhn(3, 3))}) {
        const Cochain start =
            de_rham(mesh, 0,
                    function_form([](const Vector& x) { return 0.5 + 0.2 * std::cos(pi * x[0]); }));
        Evolution fine(mesh, {{.start = start, .diffusion = 0.1}},
                       [](double t, const std::vector<Cochain>& now) {
                           const auto u = now[0].values.array();
                           return std::vector{Vector(u * (1 + std::sin(t) - u))};
                       },
                       {.steps = {.fixed_step = 1. / 256}});
        fine.march(1);
        const Cochain end = fine.form(0);
        EXPECT_NEAR(std::log2(error_after(mesh, start, 8, end) / error_after(mesh, start, 16, end)),
                    4, 0.4);
    }
}

/// Values on the boundary of a form whose derivative vanishes.
Vector closing(const Discretization& mesh, const Cochain& form) {
    if (form.side == Side::primal)
        return form.values;
    const SparseMatrix B = dual_boundary_derivative(mesh.complex(), form.degree);
    const Vector open = dual_derivative(mesh.complex(), form.degree) * form.values;
    Vector result = Vector::Zero(B.cols());
    for (Index row = 0; row < B.rows(); ++row)
        for (SparseMatrix::InnerIterator entry(B, row); entry; ++entry)
            result[entry.col()] = -open[row] / entry.value();
    return result;
}

// The twin: without the values on the boundary they do not stay constant.
TEST(evolution, constant_forms_grow_with_their_values_on_the_boundary) {
    const BoundaryConditions essential{BoundaryCondition::essential};
    for (const int n : {1, 2, 3})
        for (const Side side : {Side::primal, Side::dual})
            for (int degree = 0; degree < n; ++degree) {
                const auto mesh = circumcentric(kuhn(n, 4));
                const auto components = static_cast<Eigen::Index>(subsets(n, degree).size());
                const Cochain u = on(mesh, side, degree, [&](const Vector&) {
                    return Vector(Vector::LinSpaced(components, 1, 2));
                });
                const Vector data = closing(mesh, u);
                const auto growth = [](double t) { return 1 + t * t; };
                const auto defect = [&](bool has_data) {
                    Unknown unknown{.start = u, .diffusion = 1, .conditions = essential};
                    if (has_data)
                        unknown.boundary = [&](double t) {
                            return BoundaryForms{.values = growth(t) * data};
                        };
                    Evolution run(mesh, {unknown}, [&](double t, const std::vector<Cochain>&) {
                        return std::vector{Vector(2 * t * u.values)};
                    });
                    run.march(1);
                    return norm(mesh, run.form(0) - growth(1) * u) / norm(mesh, u);
                };
                EXPECT_LE(defect(true), 1e-4) << n << name(side) << degree;
                EXPECT_GT(defect(false), 0.1) << n << name(side) << degree;
            }
}

// The steps of the heat equation are another scheme for the same matrices.
TEST(evolution, heat_without_source_is_that_of_the_heat_solver_for_all_stars) {
    const Mesh meshes[] = {kuhn(2, 4), kuhn(3, 2), uv_sphere(8, 6)};
    for (const Mesh& input : meshes) {
        const auto plain = circumcentric(input);
        for (const StarKind kind : {StarKind::circumcentric, StarKind::galerkin}) {
            const auto mesh = plain.with_stars(kind);
            for (int degree = 0; degree <= mesh.dimension(); ++degree) {
                Cochain form{Side::primal, degree,
                             Vector::LinSpaced(mesh.complex().size(degree), -1, 1)};
                Evolution heat(mesh, {{.start = form, .diffusion = 1}}, {},
                               {.steps = {.relative_tolerance = 1e-8}});
                heat.march(0.1);
                const Cochain start = form;
                const auto solved = [&](int steps) {
                    const HeatSolver solver(
                        mesh, Side::primal, degree,
                        {.time_step = 0.1 / steps, .scheme = HeatScheme::backward_euler});
                    Cochain u = start;
                    for (int i = 0; i < steps; ++i)
                        u = solver.step(u);
                    return u;
                };
                const Cochain coarse = solved(100), fine = solved(200);
                const Cochain extrapolated = 2 * fine - coarse;
                EXPECT_LE(norm(mesh, extrapolated - heat.form(0)), 2e-3 * norm(mesh, start));
            }
        }
    }
}

TEST(evolution, diffusion_keeps_the_mean_where_nothing_flows_out) {
    for (const auto& [named, input] : meshes()) {
        const auto mesh = circumcentric(input);
        const HodgeStar star = polydec::star(mesh, 0);
        if (!star.zeros().empty() || !star.negatives().empty())
            continue;
        const Index count = mesh.complex().size(0);
        const Cochain slope{Side::primal, 0, Vector::LinSpaced(count, 0, 1)};
        Evolution heat(mesh,
                       {{.start = slope, .diffusion = mesh.volumes().primal(1).squaredNorm()}});
        const auto heat_in = [&](const Cochain& u) { return Vector(star * u.values).sum(); };
        const double before = heat_in(heat.form(0));
        heat.march(0.01);
        EXPECT_NEAR(heat_in(heat.form(0)), before, 1e-9 * std::abs(before)) << named;
    }
}

/// Gray and Scott's reaction, with u and v on either side.
Evolution gray_scott(const Discretization& mesh, const std::string& integrator, Side side) {
    const Index count = mesh.complex().size(side == Side::primal ? 0 : mesh.dimension());
    const Cochain u{side, 0, Vector::Ones(count)};
    Cochain v{side, 0, Vector::Zero(count)};
    v.values.head(count / 4).setConstant(0.5);
    return {mesh,
            {{.start = u, .diffusion = 2e-3}, {.start = v, .diffusion = 1e-3}},
            [](double, const std::vector<Cochain>& now) {
                const auto U = now[0].values.array(), V = now[1].values.array();
                return std::vector<Vector>{Vector(-U * V * V + 0.04 * (1 - U)),
                                           Vector(U * V * V - 0.1 * V)};
            },
            {.integrator = integrator, .steps = {.relative_tolerance = 1e-6}}};
}

TEST(evolution, all_integrators_give_the_same_forms) {
    const auto mesh = circumcentric(uv_sphere(8, 6));
    for (const Side side : {Side::primal, Side::dual}) {
        auto reference = gray_scott(mesh, "runge-kutta", side);
        reference.march(10);
        for (const auto& engine : engines(EngineKind::integrator)) {
            if (!engine.available)
                continue;
            auto run = gray_scott(mesh, engine.name, side);
            run.march(10);
            for (const std::size_t i : {0, 1})
                EXPECT_LE(norm(mesh, run.form(i) - reference.form(i)), 1e-3) << engine.name;
        }
    }
}

// The twin: without the integrator's memory the bits are others.
TEST(evolution, a_run_that_is_resumed_ends_in_the_same_bits) {
    const auto mesh = circumcentric(uv_sphere(8, 6));
    auto whole = gray_scott(mesh, "runge-kutta", Side::primal);
    std::vector<std::vector<Vector>> states;
    whole.march({1, 2.5, 4}, [&](const Evolution& now) { states.push_back(now.state()); });
    const auto end_of = [&](std::vector<Vector> state) {
        auto rest = gray_scott(mesh, "runge-kutta", Side::primal);
        rest.resume(1, state);
        rest.march({2.5, 4}, [](const Evolution&) {});
        return rest.state();
    };
    EXPECT_EQ(end_of(states[0]), states[2]);
    EXPECT_NE(end_of({states[0][0], Vector()}), states[2]);
    EXPECT_THROW(whole.resume(1, {states[0][0]}), InvalidInput);
}

TEST(evolution, a_march_stops_where_a_form_has_cooled_to_a_half) {
    const auto mesh = circumcentric(kuhn(2, 16));
    const Cochain u = dual_de_rham(mesh, 0, eigenform(2, Side::dual, 0));
    Evolution heat(mesh, {{.start = u, .diffusion = 1}}, {},
                   {.steps = {.relative_tolerance = 1e-8},
                    .event = [&](double, const std::vector<Cochain>& now) {
                        return inner_product(mesh, now[0], u) / inner_product(mesh, u, u) - 0.5;
                    }});
    int shown = 0;
    EXPECT_EQ(heat.march({0.01, 1, 2}, [&](const Evolution&) { ++shown; }), Arrival::at_event);
    EXPECT_EQ(shown, 2);
    EXPECT_NEAR(heat.time(), std::log(2.0) / (2 * pi * pi), 2e-4);
}

TEST(evolution, a_stiffness_of_ones_own_does_what_diffusion_does) {
    const auto mesh = circumcentric(kuhn(2, 5));
    const auto own = std::make_shared<Diffusion>(star(mesh, 0), 0.3 * symmetric_laplacian(mesh, 0),
                                                 Side::primal);
    const Cochain start = de_rham(mesh, 0, eigenform(2, Side::primal, 0));
    Evolution a(mesh, {{.start = start, .stiff = own}});
    Evolution b(mesh, {{.start = start, .diffusion = 0.3}});
    a.march(0.2);
    b.march(0.2);
    EXPECT_LE(norm(mesh, a.form(0) - b.form(0)), 1e-12);
}

TEST(evolution, what_does_not_fit_is_refused_by_its_number) {
    const auto mesh = circumcentric(kuhn(2, 2));
    const Cochain u{Side::primal, 0, Vector::Ones(9)};
    EXPECT_THROW(Evolution(mesh, {{.start = {Side::primal, 0, Vector::Ones(8)}}}), InvalidInput);
    EXPECT_THROW(Evolution(mesh, {{.start = u, .diffusion = -1}}), InvalidInput);
    std::vector<Unknown> unknowns(2, {.start = u});
    unknowns[1].boundary = [](double) { return BoundaryForms{}; };
    EXPECT_TRUE(
        says(refusal([&] { Evolution(mesh, unknowns); }), {"unknown 1", "boundary", "diffusion"}));
    const auto other = std::make_shared<Diffusion>(mesh, Side::dual, 0, DiffusionOptions{});
    EXPECT_TRUE(says(refusal([&] { Evolution(mesh, {{.start = u, .stiff = other}}); }),
                     {"unknown 0", "stiff", "dual 0-forms", "primal 0-form"}));
    Evolution short_rates(mesh, {{.start = u}}, [](double, const std::vector<Cochain>&) {
        return std::vector{Vector(Vector::Ones(3))};
    });
    EXPECT_TRUE(
        says(refusal([&] { short_rates.march(1); }), {"reaction", "3 rates", "unknown 0", "9"}));
    Evolution few_rates(mesh, {{.start = u}},
                        [](double, const std::vector<Cochain>&) { return std::vector<Vector>{}; });
    EXPECT_THROW(few_rates.march(1), InvalidInput);
}

} // namespace
} // namespace polydec::test::in_evolution
