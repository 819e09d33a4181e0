// SPDX-License-Identifier: MIT
#include "tests/solvers/cases.h"

namespace polydec::test::in_heat {

constexpr double quick = 0.1;

/// Heat shrinks an eigenform by 1 / (1 + dt lambda) with each step.
void expect_eigenforms_to_shrink(const CellComplex& complex, const HodgeStars& stars, int k) {
    const Operator applied = symmetric_laplacian({complex, stars}, k);
    DenseMatrix A(complex.size(k), complex.size(k)); // which may be dense
    for (Index i = 0; i < A.cols(); ++i)
        A.col(i) = applied * Vector::Unit(A.cols(), i);
    const auto [values, forms] = dense_modes(A, DenseMatrix(stars[k].matrix()));
    const int j = complex.dimension() - k;
    const FormSpace primal({complex, stars}, Side::primal, k),
        dual({complex, stars}, Side::dual, j);
    for (const Index i : {Index{0}, static_cast<Index>(A.rows() / 2)}) {
        const Vector form = forms.col(i);
        const double factor = 1 / (1 + quick * values[i]);
        const Vector next = heated(primal, {Side::primal, k, form}, quick).values;
        EXPECT_CLOSE(next, factor * form, 1e-8) << "k = " << k;
        const Vector flux = stars[k] * form;
        EXPECT_CLOSE(heated(dual, {Side::dual, j, flux}, quick).values, factor * flux, 1e-8)
            << "k = " << k;
        EXPECT_GT(relative_difference(next, factor * factor * form + form), 1e-3);
        const Cochain second =
            heated(primal, {Side::primal, k, form}, quick, 1, "implicit-midpoint");
        const double half = quick * values[i] / 2;
        EXPECT_CLOSE(second.values, (1 - half) / (1 + half) * form, 1e-8);
        Evolution heat({{.space = primal, .start = form, .diffusion = 1}}, {},
                       {.steps = {.relative_tolerance = 1e-8}});
        heat.march(quick);
        const double rest = std::exp(-quick * values[i]);
        EXPECT_LE((heat.form(0).values - rest * form).norm(), 1e-5 * form.norm());
    }
}

TEST(HeatByStars, keeps_conditions_on_the_boundary) {
    const auto mesh = circumcentric(shaken(grid(5, 5), 0.42, 3));
    const auto stars = mesh.with_stars(StarKind::automatic).stars();
    BoundaryConditions fixed;
    fixed.everywhere = BoundaryCondition::essential;
    const FormSpace space({mesh.complex(), stars}, Side::primal, 1, fixed);
    const Cells on = space.inside();
    ASSERT_LT(space.size(), mesh.complex().size(1));
    ASSERT_FALSE(on.stars()[1].is_diagonal());
    const Vector form = random_vector(mesh.complex().size(1), 2);
    const Vector next = heated(space, {Side::primal, 1, form}, quick).values;
    const Cochain part_of_it{Side::primal, 1, space.restrict(form)};
    const Vector there = heated({on, Side::primal, 1}, part_of_it, quick).values;
    EXPECT_CLOSE(next, space.extend(there), 1e-12);
    // the rows and columns of the edges inside, as they are
    const DenseMatrix whole(stars[1].matrix()), part(on.stars()[1].matrix());
    const auto& kept = space.free();
    EXPECT_EQ(part, DenseMatrix(whole(kept, kept)));
}

TEST(HeatByStars, has_nothing_to_do_where_conditions_fix_all) {
    const auto mesh = circumcentric(made_of({{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}}));
    SparseMatrix twice(3, 3);
    twice.setIdentity();
    twice.coeffs() *= 2;
    const auto stars = mesh.stars().with(1, twice);
    BoundaryConditions fixed;
    fixed.everywhere = BoundaryCondition::essential;
    const FormSpace space({mesh.complex(), stars}, Side::primal, 1, fixed);
    const Cells inside = space.inside();
    EXPECT_EQ(inside.stars()[1].size(), 0);
    EXPECT_FALSE(inside.stars()[1].is_diagonal());
    EXPECT_TRUE(heated(space, {Side::primal, 1, Vector::Ones(3)}, quick).values.isZero(0));
}

TEST(HeatByStars, shrinks_eigenforms_of_every_degree) {
    for (const Mesh& input :
         {shaken(grid(5, 5), 0.42, 3), shaken(kuhn(3, 2), 0.3, 3), mesh_named("torus8x6")})
        for (const StarKind kind : {StarKind::galerkin, StarKind::automatic}) {
            const auto mesh = circumcentric(input).with_stars(kind);
            for (int k = 0; k <= mesh.dimension(); ++k)
                expect_eigenforms_to_shrink(mesh.complex(), mesh.stars(), k);
        }
}

/// After a time far beyond all others of the mesh nothing but harmonic forms is left.
TEST(HeatByStars, leaves_harmonic_forms_after_the_longest_time) {
    const auto mesh = circumcentric(shaken(mesh_named("torus8x6"), 0.2, 3));
    const auto stars = mesh.with_stars(StarKind::hybrid).stars();
    ASSERT_TRUE(stars[0].is_diagonal() && !stars[1].is_diagonal());
    const Cochain form{Side::primal, 1, random_vector(mesh.complex().size(1), 2)};
    const Vector harmonic =
        hodge_decomposition({{mesh.complex(), stars}, form.side, form.degree}, form)
            .harmonic.values;
    const FormSpace space({mesh.complex(), stars}, Side::primal, 1);
    EXPECT_CLOSE(heated(space, form, 1e8).values, harmonic, 1e-6);
    EXPECT_GT(relative_difference(heated(space, form, 1).values, harmonic), 1e-3);
}

class Heat : public OverMeshes {};

TEST_P(Heat, eigenforms_decay_with_their_eigenvalues_on_both_sides) {
    const int n = mesh().n();
    for (int k = 0; k <= n; ++k)
        for (const Side side : {Side::primal, Side::dual}) {
            if (!star(mesh().volumes, k).zeros().empty() ||
                !star(mesh().volumes, k).negatives().empty() ||
                (k > 0 && !star(mesh().volumes, k - 1).zeros().empty()))
                continue;
            const int degree = side == Side::primal ? k : n - k;
            if (side == Side::dual && degree == 0 && branches(mesh().P()))
                continue;
            const auto modes = spectrum({{mesh().P(), mesh().volumes}, side, degree}, {.count = 1});
            const double lambda = modes.eigenvalues[0], dt = 1e-3;
            if (lambda < -1e-9)
                continue; // spurious, of a negative dual: grows instead
            const Cochain mode{side, degree, modes.modes.col(0)};
            const Cochain next = heated({{mesh().P(), mesh().volumes}, side, degree}, mode, dt);
            const Vector expected = mode.values / (1 + dt * lambda);
            EXPECT_CLOSE(next.values, expected, 1e-8) << name(side) << ' ' << degree;
        }
}

POLYDEC_OVER_MESHES(Heat);

TEST(HeatOrders, are_1_and_2_in_time) {
    const auto mesh = circumcentric(grid(6, 6));
    const auto modes = spectrum({mesh, Side::primal, 0}, {.count = 2});
    const double lambda = modes.eigenvalues[1], end = 0.1;
    const auto error = [&](const char* integrator, int steps) {
        const Cochain u{Side::primal, 0, modes.modes.col(1)};
        const FormSpace space({mesh.complex(), mesh.volumes()}, u.side, u.degree);
        const Cochain cooled = heated(space, u, end / steps, steps, integrator);
        return (cooled.values - std::exp(-lambda * end) * u.values).norm();
    };
    for (const auto& [integrator, order] :
         {std::pair{"backward-euler", 1.0}, {"implicit-midpoint", 2.0}})
        EXPECT_NEAR(std::log2(error(integrator, 20) / error(integrator, 40)), order, 0.1);
}

TEST(HeatMeans, are_kept_on_any_mesh_where_nothing_flows_out) {
    for (const auto& [named, input] : meshes()) {
        const auto mesh = circumcentric(input);
        const HodgeStar star = polydec::star(mesh, 0);
        if (!star.zeros().empty() || !star.negatives().empty())
            continue;
        const Index count = mesh.complex().size(0);
        const Cochain slope{Side::primal, 0, Vector::LinSpaced(count, 0, 1)};
        Evolution heat({{.space = {mesh, slope.side, slope.degree},
                         .start = slope.values,
                         .diffusion = mesh.volumes().primal(1).squaredNorm()}});
        const auto heat_in = [&](const Cochain& u) { return Vector(star * u.values).sum(); };
        const double before = heat_in(heat.form(0));
        heat.march(0.01);
        EXPECT_NEAR(heat_in(heat.form(0)), before, 1e-9 * std::abs(before)) << named;
    }
}

/// The mean of a function, and its largest distance from that.
std::pair<double, double> mean_and_range(const Discretization& mesh, const Cochain& u) {
    const HodgeStar star = polydec::star(mesh, u.side == Side::primal ? 0 : mesh.dimension());
    const Vector ones = Vector::Ones(star.size());
    const Vector of_cells = u.side == Side::primal ? star * ones : star.solve(ones);
    const double mean = of_cells.dot(u.values) / of_cells.sum();
    return {mean, (u.values.array() - mean).abs().maxCoeff()};
}

// The twin: values 0 on the boundary let the mean go.
TEST(HeatMeans, are_kept_by_steps_of_any_length_where_nothing_flows_out) {
    const BoundaryConditions natural{BoundaryCondition::natural};
    for (const auto& [name, has_boundary] :
         {std::pair{"grid4", true}, {"kuhn3", true}, {"icosphere3", false}, {"torus8x6", false}})
        for (const StarKind kind : {StarKind::circumcentric, StarKind::galerkin})
            for (const Side side : sides)
                for (const double step : {1e-3, 1e2, 1e6, 1e9, 1e12}) {
                    const auto mesh = with_stars(mesh_named(name), kind);
                    const Index size =
                        mesh.complex().size(side == Side::primal ? 0 : mesh.dimension());
                    const Cochain u{side, 0, Vector::LinSpaced(size, 1, 2)};
                    const auto [before, range] = mean_and_range(mesh, u);
                    const Cochain end = heated({mesh, side, 0, natural}, u, step, 20);
                    const auto [after, rest] = mean_and_range(mesh, end);
                    EXPECT_NEAR(after, before, 1e-14) << name << step << polydec::name(side);
                    EXPECT_LE(rest, step > 1 ? 1e-12 : range) << name << step;
                    const Cochain lost =
                        heated({mesh, side, 0, BoundaryCondition::essential}, u, step, 20);
                    EXPECT_EQ(mean_and_range(mesh, lost).first < before - 1e-2, has_boundary);
                }
}

// The mass is then below the rounding of the stiffness.
TEST(HeatMeans, are_left_by_steps_beyond_all_digits) {
    for (const int cells : {1, 4, 1000})
        for (const Side side : sides)
            for (const double step : {1.0, 1e12, 1e16, 1e20}) {
                const auto mesh = discretize(kuhn(1, cells));
                const FormSpace space(mesh, side, 0, BoundaryCondition::natural);
                const Vector start = Vector::LinSpaced(space.size(), 1, 2);
                Evolution heat({{.space = space, .start = start, .diffusion = 1}}, {},
                               {.integrator = "backward-euler",
                                .steps = {.fixed_step = step},
                                .linear_solver = "eigen.ldlt"});
                const double before = mean_and_range(mesh, heat.form(0)).first;
                heat.march(20 * step);
                const auto [mean, range] = mean_and_range(mesh, heat.form(0));
                EXPECT_NEAR(mean, before, 1e-14) << cells << name(side) << step;
                EXPECT_LE(range, 1e-12) << cells << name(side) << step;
            }
}

// A cosine on equal edges is an eigenform, and odd about the middle, unlike rounding of the mean.
TEST(HeatMeans, leave_the_rest_right_in_steps_of_any_length) {
    const int cells = 10'000;
    const auto mesh = discretize(kuhn(1, cells));
    Resolvent resolvent(
        Diffusion({mesh, Side::primal, 0, BoundaryCondition::natural}, 1, "eigen.ldlt"));
    const Vector form = (std::numbers::pi * mesh.input_points().col(0)).array().cos();
    const double eigenvalue = 2 * (1 - std::cos(std::numbers::pi / cells)) * cells * cells;
    for (const double step : {1e-3, 1.0, 1e6, 1e9, 1e12}) {
        resolvent.prepare(step);
        const Vector next = resolvent.solve(form), odd = (next - next.reverse()) / 2;
        EXPECT_CLOSE((1 + step * eigenvalue) * odd, form, 1e-7) << step;
    }
}

TEST(Heat, of_stars_that_are_matrices_does_not_mind_the_size_of_cells) {
    const auto largest_at = [](double size) {
        Mesh mesh = grid(4, 4);
        mesh.points *= size;
        const auto given =
            discretize(mesh, {.criterion = MergeCriterion::none, .star = StarKind::galerkin});
        const Cochain ones{Side::dual, 0, Vector::Ones(given.complex().size(2))};
        return heated({given, Side::dual, 0}, ones, 0.05 * size * size).values.maxCoeff();
    };
    for (const int exponent : {-38, -20, 20, 30, 38})
        EXPECT_NEAR(largest_at(std::ldexp(1, exponent)), largest_at(1), 1e-9) << exponent;
}

TEST(Heat, of_any_size_does_not_grow) {
    const auto mesh = discretize(grid(4, 4));
    const Cochain u{Side::primal, 0, random_vector(mesh.size(0), 1)};
    const Vector expected = heated({mesh, Side::primal, 0}, u, 0.1).values;
    for (const double size : {0x1p-900, 0x1p900})
        EXPECT_LE((heated({mesh, Side::primal, 0}, size * u, 0.1).values / size - expected).norm(),
                  1e-12 * expected.norm());
}

TEST(Heat, does_not_grow_where_duals_of_facets_are_negative) {
    const auto mesh = circumcentric(perturbed(grid(4, 4), 0.08, 3), {MergeCriterion::none});
    ASSERT_FALSE(star(mesh.volumes(), 1).negatives().empty());
    for (const auto& [engine, size] :
         {std::pair("eigen.ldlt", 1.), {"auto", 1.}, {"auto", 0x1p900}}) {
        Evolution run({{.space = {mesh, Side::dual, 0},
                        .start = size * random_vector(mesh.complex().size(2), 1),
                        .diffusion = 1}},
                      {},
                      {.integrator = "backward-euler",
                       .steps = {.fixed_step = 0.01},
                       .linear_solver = engine});
        EXPECT_ERROR(SolverFailure, run.march(1), "increases their norm", "negative duals",
                     "StarKind::automatic")
            << engine;
        const Cochain u = run.form(0);
        const auto positive = mesh.with_stars(StarKind::automatic);
        EXPECT_LT(norm(positive, heated({positive, Side::dual, 0}, u, 0.01)), norm(positive, u));
    }
}

} // namespace polydec::test::in_heat
