// SPDX-License-Identifier: MIT
#include "tests/shape/poisson_samples.h"

namespace polydec::test::in_goal_interval {

/// The interval of a domain whose lengths are off by a factor that the error given allows.
TEST(GoalInterval, knows_the_errors_of_lengths) {
    struct Known {
        Mesh mesh;
        double goal;
    };
    for (const Known& known : {Known{kuhn(1, 64), 1.0 / 12}, Known{kuhn(2, 32), 0.0351442537}})
        for (const double factor : {0.9991, 1.0, 1.0009}) {
            PoissonProblem problem = torsion(known.mesh);
            problem.shape.lengths *= factor;
            problem.shape.length_error = 1e-3;
            const Vector u = galerkin(problem, Vector::Zero(problem.shape.pieces.size(0)));
            const Enclosed goal = goal_interval(problem, u, problem.source);
            EXPECT_LE(goal.lower, known.goal);
            EXPECT_GE(goal.upper, known.goal);
            EXPECT_LT(goal.upper - goal.lower, 0.5 * known.goal);
            problem.shape.length_error = 0.09;
            EXPECT_REFUSED(goal_interval(problem, u, problem.source), "rounding of");
        }
}

/// Conditions of every kind, f, g and u of both signs, lengths changed at random: on one mesh the
/// best guesses move like the goal.
TEST(GoalInterval, is_for_every_shape_of_the_lengths_allowed) {
    const PartOfBoundary left{is_left, BoundaryCondition::essential},
        right{is_right, BoundaryCondition::robin, 3};
    const Mesh mesh = perturbed(kuhn(2, 16), 0.005, 3);
    const Points vertices = vertices_of(mesh);
    const Vector f = f_at(vertices), values = vertices.col(1).array() - 0.5;
    PoissonProblem problem = problem_of({"", mesh, {left, right}, true, 0.7}, mesh, f);
    const DenseMatrix goal = problem.source.array() * problem.source.array() - 1;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> change(-1e-3, 1e-3);
    const Vector u = galerkin(problem, values);
    const auto half = [](const Enclosed& interval) {
        return (interval.upper - interval.lower) / 2;
    };
    const Enclosed exact = goal_interval(problem, u, goal);
    problem.shape.length_error = 1e-3;
    const Enclosed wider = goal_interval(problem, u, goal);
    EXPECT_EQ(wider.value, exact.value);
    for (int i = 0; i < 8; ++i) {
        PoissonProblem other = problem;
        other.shape.length_error = 0;
        for (double& length : other.shape.lengths)
            length *= 1 + (i == 0 ? 1e-3 : i == 1 ? -1e-3 : change(random));
        const Enclosed there = goal_interval(other, galerkin(other, values), goal);
        EXPECT_LE(std::abs(there.value - exact.value), half(wider) - half(exact));
    }
}

TEST(GoalInterval, of_turned_needles_encloses_their_area) {
    for (const double angle : {0.0, 0.3, 0.7, 1.1, 2.5}) {
        Mesh needles = kuhn(2, 1);
        for (auto point : needles.points.rowwise()) {
            const double x = point[0] + 0.3 * point[1], y = 1e-6 * point[1];
            point << x * std::cos(angle) - y * std::sin(angle),
                x * std::sin(angle) + y * std::cos(angle);
        }
        PoissonProblem problem = torsion(needles);
        const DenseMatrix goal = problem.source;
        problem.source.setZero();
        const Enclosed area = goal_interval(problem, Vector::Ones(4), goal);
        EXPECT_LE(area.lower, 1e-6 * (1 + 1e-15)) << angle;
        EXPECT_GE(area.upper, 1e-6 * (1 - 1e-15)) << angle;
        EXPECT_LT(area.upper - area.lower, 1e-7) << angle;
    }
}

} // namespace polydec::test::in_goal_interval
