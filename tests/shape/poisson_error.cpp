// SPDX-License-Identifier: MIT
#include "tests/shape/poisson_samples.h"

namespace polydec::test::in_poisson_error {

std::vector<Sample> samples() {
    const PartOfBoundary all{is_any, BoundaryCondition::essential},
        left{is_left, BoundaryCondition::essential}, robin{is_any, BoundaryCondition::robin, 2.5},
        right{is_right, BoundaryCondition::robin, 3};
    const Mesh square = kuhn(2, 6);
    return {{"square", square, {all}},
            {"square of two materials", square, {left, right}, true, 0.7},
            {"square, Robin", square, {robin}},
            {"square, flow alone", square, {}, false, 0.7},
            {"square, mixed", square, {left}, false, -1},
            {"L", l_shape(4), {all}},
            {"cube", cube_surface(4)},
            {"tetrahedron", tetrahedron_surface(5)},
            {"pillow", pillow(8)},
            {"torus", perturbed(torus(14, 8), 0.05, 1)},
            {"Moebius", moebius(48, 4), {all}}};
}

/// Two functions of the same mesh: squares of the norms of their difference, energy and L2.
std::array<double, 2> squared_difference(const PoissonProblem& problem, const Vector& u,
                                         const Vector& v) {
    const PoissonForms forms(problem.shape, "auto");
    DenseMatrix difference = forms.at_corners(u - v);
    if (forms.vertices().kernel.cols() > 0) {
        double mean = 0;
        for (Index s = 0; s < forms.simplices(); ++s)
            mean += forms.volumes()[s] * difference.row(s).mean() / forms.volumes().sum();
        difference.array() -= mean;
    }
    double mass = 0;
    for (Index s = 0; s < forms.simplices(); ++s)
        mass += forms.mass(s, difference, difference);
    return {forms.energy(difference, difference), mass};
}

TEST(PoissonError, is_between_the_true_one_and_a_little_more) {
    for (const Sample& sample : samples()) {
        const Mesh& mesh = sample.mesh;
        const Points vertices = vertices_of(mesh);
        const Vector f = f_at(vertices), values = 0.3 * vertices.col(0);
        const PoissonProblem problem = problem_of(sample, mesh, f);
        Vector u = galerkin(problem, values);
        const PoissonError error = poisson_error(problem, u);

        Mesh fine = mesh;
        Vector coarse = u, fine_f = f;
        for (int step = 0; step < 2; ++step) {
            const Pieces before = unmerged(fine).pieces;
            coarse = divided(before, coarse), fine_f = divided(before, fine_f);
            fine = test::divided(fine);
        }
        const PoissonProblem same = problem_of(sample, fine, fine_f);
        const Vector reference = galerkin(same, coarse);
        const double off = poisson_error(same, reference, {.l2_limit = 0}).energy;
        const auto [energy, mass] = squared_difference(same, coarse, reference);
        // Galerkin's errors are orthogonal
        EXPECT_GE(error.energy, std::sqrt(energy)) << sample.name;
        EXPECT_LE(error.energy, 1.6 * std::sqrt(energy + off * off)) << sample.name;
        ASSERT_TRUE(error.l2) << sample.name;
        EXPECT_GE(*error.l2, std::sqrt(mass)) << sample.name;
        EXPECT_LE(*error.l2, 6 * std::sqrt(mass)) << sample.name;
        EXPECT_LE(error.averaged_gradient, 0.5 * error.energy + error.oscillation);
        EXPECT_NEAR(error.shares.sum(), 1, 1e-9);
    }
}

/// |grad u|^2 = int u, the torsion of the cross section over 4, is known in digits.
TEST(PoissonError, is_above_the_true_one_of_torsion_at_order_1_and_2_and_a_goal_is_enclosed) {
    struct Known {
        Mesh mesh;
        double torsion, order;
    };
    for (const Known& known :
         {Known{kuhn(2, 8), 0.0351442537, 1}, Known{l_shape(6), 0.2140758036, 2.0 / 3}}) {
        Mesh mesh = known.mesh;
        std::vector<double> energies, squares, widths;
        for (int step = 0; step < 3; ++step, mesh = test::divided(mesh)) {
            const PoissonProblem problem = torsion(mesh);
            const Vector u = galerkin(problem, Vector::Zero(problem.shape.pieces.size(0)));
            const PoissonError error = poisson_error(problem, u);
            const double truth = std::sqrt(known.torsion - error.size * error.size);
            EXPECT_GE(error.energy, truth * (1 - 1e-6));
            EXPECT_LE(error.energy, 1.4 * truth);
            EXPECT_NEAR(error.averaged_gradient, error.energy / 2, 1e-12);
            EXPECT_EQ(error.oscillation, 0);
            energies.push_back(error.energy), squares.push_back(*error.l2);
            const Enclosed goal = goal_interval(problem, u, problem.source);
            EXPECT_LE(goal.lower, known.torsion);
            EXPECT_GE(goal.upper, known.torsion - 1e-10);
            EXPECT_NEAR(goal.value, known.torsion, 0.2 * (goal.upper - goal.lower));
            widths.push_back(goal.upper - goal.lower);
        }
        EXPECT_GT(std::log2(energies[1] / energies[2]), known.order - 0.08);
        EXPECT_GT(std::log2(squares[1] / squares[2]), 2 * known.order - 0.16);
        EXPECT_GT(std::log2(widths[1] / widths[2]), 2 * known.order - 0.16);
    }
}

TEST(PoissonError, of_a_cube_of_tetrahedra_is_above_that_against_a_finer_one) {
    const PoissonProblem coarse = torsion(kuhn(3, 3)), fine = torsion(kuhn(3, 12));
    const auto squared_size = [](const PoissonProblem& problem, double& bound) {
        const Vector u = galerkin(problem, Vector::Zero(problem.shape.pieces.size(0)));
        const PoissonError error = poisson_error(problem, u, {.l2_limit = 0});
        bound = error.energy;
        return error.size * error.size;
    };
    double of_coarse = 0, of_fine = 0;
    const double difference = squared_size(fine, of_fine) - squared_size(coarse, of_coarse);
    EXPECT_GE(of_coarse * of_coarse, difference);
    EXPECT_LE(of_coarse, 1.6 * std::sqrt(difference + of_fine * of_fine));
}

/// Pythagoras: |u - v|^2 = |u - u_h|^2 + |u_h - v|^2, and the bound has the same of fluxes.
TEST(PoissonError, of_any_function_grows_by_its_distance_from_galerkins) {
    const Mesh mesh = perturbed(kuhn(2, 6), 0.02, 1);
    for (const BoundaryCondition condition :
         {BoundaryCondition::essential, BoundaryCondition::robin}) {
        PoissonProblem problem = torsion(mesh);
        problem.shape.conditions = {condition, {}, {2.5}};
        const Vector u = galerkin(problem, Vector::Zero(problem.shape.pieces.size(0)));
        const double least = poisson_error(problem, u).energy;
        Vector other = u;
        for (Index v = 0; v < u.size(); ++v)
            if (u[v] != 0)
                other[v] += 0.01 * std::sin(double(7 * v));
        const PoissonError error = poisson_error(problem, other);
        const auto [energy, mass] = squared_difference(problem, u, other);
        EXPECT_NEAR(error.energy * error.energy, least * least + energy, 1e-12);
        EXPECT_GT(*error.l2, std::sqrt(mass));
    }
}

TEST(PoissonError, of_f_without_means_is_not_forgotten) {
    const Mesh mesh = kuhn(2, 4);
    PoissonProblem problem = torsion(mesh);
    const Index triangles = problem.shape.pieces.size(2);
    problem.source.resize(triangles, 3);
    for (Index t = 0; t < triangles; ++t) {
        const double middle = centroid(mesh, problem.shape.pieces, 2, t)[0];
        for (int i = 0; i < 3; ++i)
            problem.source(t, i) =
                middle * (mesh.points(problem.shape.pieces.simplices(2)(t, i), 0) - middle);
    }
    const Vector none = Vector::Zero(problem.shape.pieces.size(0));
    const PoissonError error = poisson_error(problem, none);
    const PoissonForms forms(problem.shape, "auto");
    // some function v with zero values on the boundary: |u| >= (f, v) / |v|
    const Vector u = galerkin(problem, none);
    const LocalData data = forms.local(problem.source, {});
    const DenseMatrix v = forms.at_corners(u);
    EXPECT_GT(forms.load(data, v), 0);
    EXPECT_GE(error.energy, forms.load(data, v) / std::sqrt(forms.energy(v, v)));
}

TEST(PoissonError, of_a_linear_solution_is_0) {
    const Mesh mesh = perturbed(kuhn(2, 6), 0.02, 1);
    PoissonProblem problem = torsion(mesh);
    const PoissonForms forms(problem.shape, "auto");
    // u = 1 + 2 x - y is linear
    problem.source.setZero();
    const Points vertices = vertices_of(mesh);
    const Vector linear = 1 + 2 * vertices.col(0).array() - vertices.col(1).array();
    const PoissonError none = poisson_error(problem, linear);
    EXPECT_LT(none.energy, 1e-12);
    EXPECT_LT(*none.l2, 1e-12);
    EXPECT_NEAR(none.size, std::sqrt(5 * forms.volumes().sum()), 1e-12);
}

TEST(PoissonError, is_compared_with_the_gradient_alone) {
    PoissonProblem problem = torsion(perturbed(kuhn(2, 6), 0.02, 1));
    const Vector u = galerkin(problem, Vector::Zero(problem.shape.pieces.size(0)));
    const double size = poisson_error(problem, u).size;
    for (const double alpha : {0.5, 2.0, 1e3}) {
        problem.shape.conditions = {BoundaryCondition::robin, {}, {alpha}};
        const Vector shifted = u.array() + 7;
        EXPECT_NEAR(poisson_error(problem, shifted, {.l2_limit = 0}).size, size, 1e-12 * size);
    }
}

/// The greatest |sigma|^2 - |grad u_h|^2 over |f|^2, for f constant on simplices.
TEST(PoissonError, of_L2_is_by_a_constant_a_little_above_the_least) {
    for (const BoundaryConditions& conditions : {BoundaryConditions{BoundaryCondition::essential},
                                                 BoundaryConditions{BoundaryCondition::natural}}) {
        PoissonProblem problem = torsion(perturbed(kuhn(2, 4), 0.03, 2));
        problem.shape.conditions = conditions;
        const PoissonForms forms(problem.shape, "auto");
        const Index m = forms.simplices();
        DenseMatrix gaps(m, m);
        std::vector<PoissonPair> pairs;
        for (Index s = 0; s < m; ++s) {
            problem.source.setZero();
            problem.source(s, 0) = 1;
            const LocalData data = forms.local(problem.source, {});
            const DenseMatrix none = DenseMatrix::Zero(m, 3);
            pairs.push_back(forms.pair(forms.to_galerkin(none, data).values.cast<double>(), data));
        }
        double largest = 0;
        for (Index s = 0; s < m; ++s) {
            largest = std::max(largest, forms.poincare(s));
            for (Index t = 0; t < m; ++t)
                gaps(s, t) = forms.products(pairs[s], pairs[t]).sum() /
                             std::sqrt(forms.volumes()[s] * forms.volumes()[t]);
        }
        const double least = Eigen::SelfAdjointEigenSolver<DenseMatrix>(gaps).eigenvalues()[m - 1];
        const auto found = l2_constant_squared(forms, "auto");
        ASSERT_TRUE(found);
        EXPECT_GE(*found - largest, least);
        EXPECT_LE(*found - largest, 1.011 * least);
    }
}

TEST(PoissonError, of_separate_simplices_without_given_values_is_that_of_the_rest_of_f) {
    for (const Index count : {1, 3, 150}) {
        Mesh mesh;
        mesh.points.resize(3 * count, 2);
        mesh.simplices.resize(count, 3);
        for (Index t = 0; t < count; ++t) {
            mesh.points.middleRows(3 * t, 3) << 2 * t, 0, 2 * t + 1, 0, 2 * t, 1;
            mesh.simplices.row(t) << 3 * t, 3 * t + 1, 3 * t + 2;
        }
        PoissonProblem problem{unmerged(mesh), DenseMatrix::Ones(count, 1), {}};
        const Vector zero = Vector::Zero(3 * count);
        const PoissonError none = poisson_error(problem, zero); // f of mean 0 is 0
        EXPECT_EQ(none.energy, 0);
        ASSERT_TRUE(none.l2) << count;
        EXPECT_EQ(*none.l2, 0);
        problem.source = mesh.points.col(0).reshaped(3, count).transpose();
        const PoissonError error = poisson_error(problem, zero);
        ASSERT_TRUE(error.l2) << count;
        EXPECT_LE(error.energy, 2 * error.oscillation);
        EXPECT_LE(*error.l2, error.energy);
    }
}

TEST(PoissonError, of_L2_is_known_up_to_a_limit) {
    const PoissonProblem problem{unmerged(kuhn(2, 4)), DenseMatrix::Ones(32, 1), {}};
    const Vector u = Vector::Zero(25);
    const PoissonError below = poisson_error(problem, u, {.l2_limit = 32}),
                       above = poisson_error(problem, u, {.l2_limit = 31}),
                       never = poisson_error(problem, u, {.l2_limit = 0});
    EXPECT_TRUE(below.l2);
    EXPECT_TRUE(below.warnings.empty() && never.warnings.empty());
    EXPECT_FALSE(above.l2 || never.l2);
    ASSERT_EQ(above.warnings.size(), 1);
    EXPECT_SAYS(above.warnings[0], "L2", "above 31 simplices");
    EXPECT_EQ(above.energy, below.energy);
}

TEST(PoissonError, of_L2_is_known_of_any_few_simplices_by_any_engine) {
    const Mesh curve = made_of({{0}, {1}, {2.5}}, {{0, 1}, {1, 2}}),
               apart = made_of({{0, 0}, {1, 0}, {1, 1}, {5, 5}, {6, 5}, {6, 6}, {5, 6}},
                               {{0, 1, 2}, {3, 4, 5}, {3, 5, 6}}),
               solid = made_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}},
                               {{0, 1, 2, 3}, {1, 2, 3, 4}});
    for (const Mesh& mesh : {curve, kuhn(1, 1), kuhn(2, 1), kuhn(2, 2), apart, solid, kuhn(3, 1)})
        for (const auto condition : {BoundaryCondition::natural, BoundaryCondition::essential}) {
            PoissonProblem problem{.shape = unmerged(mesh), .source = {}};
            problem.shape.conditions = {condition};
            const Pieces& pieces = problem.shape.pieces;
            problem.source = Vector::LinSpaced(pieces.size(pieces.dimension()), -1, 2);
            const Vector u = Vector::Zero(pieces.size(0));
            const auto of = [&](const char* engine) {
                return poisson_error(problem, u, {.linear_solver = engine}).l2.value_or(-1);
            };
            EXPECT_GE(of("auto"), 0) << "n = " << mesh.dimension();
            EXPECT_NEAR(of("eigen.ldlt"), of("auto"), 1e-9 * of("auto"));
        }
}

TEST(PoissonError, of_a_mesh_takes_what_the_solver_takes_also_on_merged_cells) {
    const Mesh square = kuhn(2, 8);
    const Discretization merged = discretize(square),
                         apart = discretize(square, {.criterion = MergeCriterion::none});
    ASSERT_LT(merged.complex().size(2), apart.complex().size(2));
    std::vector<double> bounds;
    Vector u;
    for (const Discretization& mesh : {apart, merged}) {
        const auto left =
            essential_where(cell_centers(mesh, 1), [](const Vector& p) { return p[0] < 1e-9; });
        const PoissonSolver solver({mesh, Side::primal, 0, left});
        const Vector f = Vector::Ones(mesh.complex().size(0)),
                     flow = 0.5 * Vector::Ones(mesh.complex().size(1));
        if (u.size() == 0)
            u = solver
                    .solve({Side::primal, 0, f},
                           {.derivative_flow = outward_flow(mesh, Side::primal, flow)})
                    .form.values;
        bounds.push_back(poisson_error(poisson_problem(mesh, left, {}, f, flow), u).energy);
    }
    EXPECT_NEAR(bounds[0], bounds[1], 1e-12);
    EXPECT_LT(bounds[0], 0.16);
}

TEST(PoissonError, is_in_units_of_any_size) {
    PoissonProblem problem = torsion(kuhn(2, 3));
    problem.shape.conditions = {BoundaryCondition::robin, {}, {2}};
    problem.flow = Vector::Constant(problem.shape.pieces.size(1), 0.5);
    problem.shape.conductivity = Vector::Constant(problem.shape.pieces.size(2), 3);
    const Vector u = galerkin(problem, Vector::Zero(problem.shape.pieces.size(0)));
    const PoissonError error = poisson_error(problem, u);
    const Enclosed goal = goal_interval(problem, u, problem.source);
    for (const auto& [length, value, kappa] :
         {std::array{1e90, 1e-80, 1.0}, {1e-90, 1e60, 1e30}, {3.0, 1e130, 1e-20}}) {
        PoissonProblem same = problem;
        same.shape.lengths *= length;
        same.shape.conditions.coefficients = {2 * kappa / length};
        same.shape.conductivity *= kappa;
        same.source *= kappa * (value / length / length);
        same.flow *= kappa * value / length;
        const PoissonError found = poisson_error(same, u * value);
        const double energy = value * std::sqrt(kappa);
        EXPECT_NEAR(found.energy / energy, error.energy, 1e-12);
        EXPECT_NEAR(found.averaged_gradient / energy, error.averaged_gradient, 1e-12);
        EXPECT_NEAR(found.size / energy, error.size, 1e-12);
        EXPECT_NEAR(*found.l2 / value / length, *error.l2, 1e-9);
        EXPECT_LT((found.shares - error.shares).cwiseAbs().maxCoeff(), 1e-12);
        const Enclosed there = goal_interval(same, u * value, problem.source);
        EXPECT_NEAR(there.lower / value / length / length, goal.lower, 1e-12);
    }
    problem.shape.lengths *= 1e90;
    problem.source *= 1e70;
    EXPECT_FALSE(poisson_error(problem, u * 1e250).l2); // 1e340
}

TEST(PoissonError, of_what_does_not_fit_is_refused) {
    const PoissonProblem problem = torsion(kuhn(2, 2));
    const Vector u = Vector::Zero(problem.shape.pieces.size(0));
    PoissonProblem other = problem;
    other.source.resize(3, 1);
    EXPECT_THROW(poisson_error(other, u), InvalidInput);
    other = problem, other.source(0, 0) = std::nan("");
    EXPECT_THROW(poisson_error(other, u), InvalidInput);
    other = problem, other.flow = Vector::Zero(2);
    EXPECT_THROW(poisson_error(other, u), InvalidInput);
    other = problem, other.shape.functions = ShapeFunctions::twisted;
    EXPECT_THROW(poisson_error(other, u), InvalidInput);
    EXPECT_THROW(poisson_error(problem, u.head(2)), InvalidInput);
    other = problem, other.shape.conditions = {BoundaryCondition::natural};
    EXPECT_REFUSED(goal_interval(other, u, problem.source), "constants");
}

} // namespace polydec::test::in_poisson_error
