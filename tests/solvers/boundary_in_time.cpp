// SPDX-License-Identifier: MIT
// Forms that change in time with what is known of them on the boundary.
#include "tests/solvers/cases.h"

namespace polydec::test::in_boundary_in_time {

struct Stationary {
    double rate = 0;    ///< what is left of it at the solution of Delta u = f, relative
    double no_data = 0; ///< the same without what the data add
    double form = 0;    ///< from values to the form and back, relative
};

Stationary stationary(const Discretization& mesh, Side side, int degree, Where where) {
    const auto conditions = conditions_of(mesh, where);
    const PoissonSolver solver({mesh, side, degree, conditions});
    const int k = cell_degree(mesh.complex(), side, degree);
    const Cochain f{side, degree, random_vector(mesh.complex().size(k), 5)};
    const auto data = random_data(mesh.complex(), side, degree);
    const auto solution = solver.solve(f, data);

    const Diffusion diffusion({mesh, side, degree, conditions});
    const Vector values = diffusion.values_of(solution.form.values, data);
    const Vector source = diffusion.values_of((f - solution.removed).values);
    const Vector spreads = diffusion.rate(values), given = diffusion.boundary_rate(data);
    const double size = spreads.norm() + given.norm() + source.norm();
    return {(spreads + given + source).norm() / size, (spreads + source).norm() / size,
            relative_difference(diffusion.form_of(values, data), solution.form.values)};
}

std::vector<Case> small_meshes() {
    return {{"interval", 5}, {"squares", 4}, {"hexagons", 4}, {"triangles", 4}, {"cubes", 2}};
}

// The twin: without what the data add something is left.
TEST(BoundaryInTime, solutions_of_source_problems_stand_still) {
    int seen = 0;
    for (Case cells : small_meshes())
        for (const StarKind star : {StarKind::circumcentric, StarKind::galerkin}) {
            cells.star = star;
            const auto& mesh = cells.mesh(cells.coarse);
            for_all_conditions(mesh.dimension(), [&](Side side, int degree, Where where) {
                Stationary found;
                const auto refused =
                    refusal([&] { found = stationary(mesh, side, degree, where); });
                if (refused.find("is not positive: the duals of") != std::string::npos ||
                    refused.find("has no length") != std::string::npos)
                    return; // Delta u = f, or its diffusion
                ASSERT_EQ(refused, "accepted");
                ++seen;
                EXPECT_LE(found.rate, 1e-7);
                EXPECT_GT(found.no_data, 1e-3);
                EXPECT_LE(found.form, 1e-9);
            });
        }
    EXPECT_GE(seen, 200);
}

/// cos(4 t) times a smooth form, with the data and the source that it has: the error at the time
/// 1/4 in the norm of the form.
double error_in_time(const Discretization& mesh, Side side, int degree, Where where, bool moves) {
    const WaveForm wave(mesh.dimension(), degree, 1.5);
    const Cochain exact = exact_form(mesh, side, wave);
    const auto data = data_of(mesh, side, wave, where);
    const auto at = [](double t, const Vector& values) { return Vector(std::cos(4 * t) * values); };
    Unknown unknown{.space = {mesh, side, degree, conditions_of(mesh, where)},
                    .start = exact.values,
                    .diffusion = 1};
    unknown.boundary = [=](double t) {
        const double now = moves ? t : 0;
        return BoundaryForms{at(now, data.values), at(now, data.codifferential), at(now, data.flow),
                             at(now, data.derivative_flow)};
    };
    const double eigenvalue = wave.eigenvalue();
    Evolution run({unknown},
                  [=](double t, const std::vector<Cochain>&) {
                      const double factor = eigenvalue * std::cos(4 * t) - 4 * std::sin(4 * t);
                      return std::vector{Vector(factor * exact.values)};
                  },
                  {.steps = {.fixed_step = 1.0 / 64}});
    run.march(0.25);
    return size_of(mesh, run.form(0) - std::cos(1) * exact) / size_of(mesh, exact);
}

// Orders as without time: see form_sources.cpp. The twin: data that stay as they were.
TEST(BoundaryInTime, forms_with_data_that_change_converge) {
    struct Row : Case {
        double primal_order, dual_order;
    };
    for (const Row& row :
         {Row{{"squares"}, 1.7, 1.4}, Row{{"triangles", 8, 16, StarKind::galerkin}, 1.3, 1.0},
          Row{{"cubes", 3, 5}, 1.5, 1.3}})
        for_all_conditions(row.dimension(), [&](Side side, int degree, Where where) {
            const auto error = [&](const Discretization& mesh) {
                return error_in_time(mesh, side, degree, where, true);
            };
            EXPECT_GE(order(row, error), side == Side::primal ? row.primal_order : row.dual_order);
            EXPECT_GT(error_in_time(row.mesh(row.coarse), side, degree, where, false), 0.05);
        });
}

// The twin: a single step passes over two events.
TEST(BoundaryInTime, events_are_found_where_all_values_are_fixed) {
    const auto mesh = discretize(grid(1, 1));
    const FormSpace space(mesh, Side::primal, 0, {BoundaryCondition::essential});
    const auto marched = [&](auto value, double level, double step) {
        Unknown unknown{.space = space, .start = Vector::Zero(4), .diffusion = 1};
        unknown.boundary = [=](double t) {
            return BoundaryForms{.values = Vector::Constant(4, value(t))};
        };
        Evolution run({unknown}, {},
                      {.steps = {.largest_step = step},
                       .event = [=](double, const std::vector<Cochain>& now) {
                           return now[0].values[0] - level;
                       }});
        const bool is_event = run.march(1) == Arrival::at_event;
        return std::pair(is_event, run.time());
    };
    const auto rising = [](double t) { return t; };
    const auto humped = [](double t) { return t * (1 - t); };
    EXPECT_EQ(marched(rising, 0.3, 0), std::pair(true, 0.3));
    EXPECT_EQ(marched(rising, 1, 0), std::pair(true, 1.0));
    EXPECT_EQ(marched(rising, 2, 0), std::pair(false, 1.0));
    EXPECT_EQ(marched(rising, 0, 0), std::pair(false, 1.0)) << "it does not count at the start";
    EXPECT_NEAR(marched(humped, 0.16, 0.1).second, 0.2, 1e-15);
    EXPECT_FALSE(marched(humped, 0.16, 0).first) << "one step passes over both";
}

} // namespace polydec::test::in_boundary_in_time
