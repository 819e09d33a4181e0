// SPDX-License-Identifier: MIT
#include "tests/shape/poisson_samples.h"

#include <cmath>

namespace polydec::test::in_poisson_rounding {

/// u = 1/alpha + x - x^2/2 where alpha u + du/dnu = 0 at x = 0, and there is no flow elsewhere.
TEST(ProvedNumbers, enclose_the_integral_of_a_solution_however_large_its_constant_is) {
    const Mesh mesh = kuhn(2, 12);
    for (const double alpha : {1.0, 0x1p-7, 0x1p-14, 0x1p-20}) {
        const auto conditions = conditions_of(mesh, {{is_left, BoundaryCondition::robin, alpha}});
        const Shape shape = unmerged(mesh, conditions);
        const Pieces& pieces = shape.pieces;
        const PoissonProblem problem{shape, DenseMatrix::Ones(pieces.size(2), 1), {}};
        const Points vertices = vertices_of(mesh);
        const auto x = vertices.col(0).array();
        const Vector u = 1 / alpha + x - x * x / 2;
        const Enclosed found = goal_interval(problem, u, problem.source);
        const long double integral = 1 / static_cast<long double>(alpha) + 1 / 3.0L;
        EXPECT_LE(found.lower, integral) << alpha;
        EXPECT_GE(found.upper, integral) << alpha;
        EXPECT_LT(found.upper - found.lower, 1.5e-3) << alpha;
    }
}

/// u = g at 0, no flow at 1, f = 0; u_h is g but at 1, where it is the next number.
TEST(ProvedNumbers, know_an_error_of_one_rounding) {
    for (const auto& [g, cells] : {std::pair{1.5, 8}, {300.0, 3}, {149705.4, 3}, {1e8, 5}}) {
        const Mesh mesh = kuhn(1, cells);
        const auto conditions = conditions_of(mesh, {{is_left, BoundaryCondition::essential}});
        const Shape shape = unmerged(mesh, conditions);
        const PoissonProblem problem{shape, DenseMatrix::Zero(cells, 1), {}};
        Vector u = Vector::Constant(cells + 1, g);
        Eigen::Index last = 0;
        vertices_of(mesh).col(0).maxCoeff(&last);
        u[last] = std::nextafter(g, HUGE_VAL);
        const double step = std::nextafter(g, HUGE_VAL) - g, energy = step * std::sqrt(cells),
                     l2 = step / std::sqrt(3 * cells);
        const PoissonError error = poisson_error(problem, u);
        EXPECT_GE(error.energy, energy) << g;
        EXPECT_LE(error.energy, energy * (1 + 1e-6)) << g;
        ASSERT_TRUE(error.l2);
        EXPECT_GE(*error.l2, l2) << g;
        EXPECT_LE(*error.l2, l2 * (1 + 1e-6)) << g;
    }
}

/// A stiff Robin condition at 1, where u_h is much smaller than beside.
TEST(ProvedNumbers, know_a_small_value_beside_large_ones) {
    const Mesh mesh = kuhn(1, 2);
    const auto conditions = conditions_of(mesh, {{is_left, BoundaryCondition::essential},
                                                 {is_right, BoundaryCondition::robin, 1e60}});
    const Shape shape = unmerged(mesh, conditions);
    const PoissonProblem problem{shape, DenseMatrix::Zero(2, 1), {}};
    Vector u = 1 - vertices_of(mesh).col(0).array(); // of f = 0 and u(0) = 1 the exact one is 1 - x
    std::replace(u.begin(), u.end(), 0.0, 1e-12);
    EXPECT_GE(poisson_error(problem, u, {.l2_limit = 0}).energy, 1e18 * (1 - 1e-14));
}

/// u = c + s x with alpha u + du/dnu = 0 at 0, and = -1 at 1, where goals are as small as u there.
TEST(ProvedNumbers, enclose_the_integral_of_a_solution_that_stiff_conditions_keep_small) {
    const Mesh mesh = kuhn(1, 8);
    for (const double alpha : {1e3, 1e9, 1e12, 1e17}) {
        const auto conditions = conditions_of(mesh, {{is_any, BoundaryCondition::robin, alpha}});
        PoissonProblem problem{unmerged(mesh, conditions), DenseMatrix::Zero(8, 1),
                               Vector::Zero(9)};
        const long double s = -1 / (static_cast<long double>(alpha) + 2), c = s / alpha;
        const Points vertices = vertices_of(mesh);
        Vector u(9);
        for (Index v = 0; v < 9; ++v) {
            u[v] = static_cast<double>(c + s * vertices(v, 0));
            problem.flow[v] = vertices(v, 0) == 1 ? -1 : 0;
        }
        const Enclosed found = goal_interval(problem, u, DenseMatrix::Ones(8, 1));
        EXPECT_LE(found.lower, c + s / 2) << alpha;
        EXPECT_GE(found.upper, c + s / 2) << alpha;
        EXPECT_LT(found.upper - found.lower, 1e-3 / alpha) << alpha;
    }
}

/// f less its mean is rounding alone, and nearly constant.
TEST(ProvedNumbers, take_a_constant_f_without_given_values_for_none) {
    for (int seed = 0; seed < 40; ++seed) {
        const Shape shape = unmerged(perturbed(kuhn(2, 2 + seed % 5), 0.05, seed));
        const double f = 0.3 + 0.01 * seed;
        const PoissonProblem problem{shape, DenseMatrix::Constant(shape.pieces.size(2), 1, f), {}};
        EXPECT_LT(poisson_error(problem, Vector::Zero(shape.pieces.size(0))).energy, 1e-15);
    }
}

TEST(ProvedNumbers, are_not_lost_beside_large_ones_and_refused_where_doubles_end) {
    PoissonProblem problem = torsion(kuhn(2, 4));
    const Vector u = Vector::Constant(problem.shape.pieces.size(0), 300);
    constexpr double torsion_of_square = 0.0351442537;
    for (const double f : {1e-100, 1e-160, 1e-250}) {
        problem.source.setConstant(f);
        EXPECT_GE(poisson_error(problem, u, {.l2_limit = 0}).energy,
                  f * std::sqrt(torsion_of_square));
    }
    PoissonProblem small = torsion(kuhn(3, 1));
    small.shape.lengths *= 1e-40;
    small.source *= 1e-230;
    EXPECT_REFUSED(poisson_error(small, Vector::Zero(small.shape.pieces.size(0))), "range");
}

} // namespace polydec::test::in_poisson_rounding
