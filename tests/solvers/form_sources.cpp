// SPDX-License-Identifier: MIT
#include "tests/solvers/cases.h"

namespace polydec::test::in_form_sources {

/// Norm of the error over that of the solution; the source is `factor` times that of the solution.
double error(const Discretization& mesh, Side side, int degree, Where where, double factor = 1) {
    const WaveForm wave(mesh.dimension(), degree, 1.5);
    const Cochain exact = exact_form(mesh, side, wave);
    PoissonSolver solver({mesh, side, degree, conditions_of(mesh, where)});
    // orthonormal harmonic forms have the products with a form as coefficients
    DenseMatrix harmonic = solver.harmonic_forms();
    Vector coefficients(harmonic.cols());
    for (Index i = 0; i < coefficients.size(); ++i)
        coefficients[i] = inner_product(mesh, exact, {side, degree, harmonic.col(i)});
    const auto solution = solver.solve(factor * wave.eigenvalue() * exact,
                                       data_of(mesh, side, wave, where), coefficients);
    return size_of(mesh, solution.form - exact) / size_of(mesh, exact);
}

struct Row : Case {
    double primal_order, dual_order; ///< at least, of every degree and condition
    int conditions = 4;              ///< how many of these converge in every degree
};

class FormSources : public testing::TestWithParam<Row> {};

TEST_P(FormSources, of_every_degree_side_and_condition_converge) {
    const Row& row = GetParam();
    const int n = row.dimension();
    int solved = 0;
    for_all_conditions(n, [&](Side side, int k, Where where) {
        if (static_cast<int>(where) >= row.conditions)
            return;
        double found = 0;
        const auto refused = refusal([&] {
            found = order(row, [&](const auto& mesh) { return error(mesh, side, k, where); });
        });
        if (refused != "accepted") { // duals that are not positive, of other stars
            EXPECT_EQ(row.star, StarKind::circumcentric);
            EXPECT_TRUE(k == n ? says(refused, {"facet", "no length"})
                               : says(refused, {"mass", "not positive"}));
            return;
        }
        ++solved;
        EXPECT_GE(found, side == Side::primal ? row.primal_order : row.dual_order);
    });
    EXPECT_GE(solved, std::min(3, row.conditions) * (n + 1));
}

TEST_P(FormSources, do_not_converge_to_another_solution) {
    const auto& mesh = Case{GetParam().pattern}.mesh(GetParam().coarse);
    for (const Side side : sides) { // both on vertices, whose duals are positive everywhere
        const int degree = side == Side::primal ? 0 : mesh.dimension();
        EXPECT_GT(error(mesh, side, degree, Where::natural, 1.5), 0.05) << name(side);
    }
}

constexpr auto by_duals = StarKind::circumcentric, galerkin = StarKind::galerkin;

// Order 2 where cells are alike; 3/2 of values on half duals at a boundary, where they are known at
// the end and not in the middle, and on triangles that are not alike; 1 of Whitney forms between
// degrees 0 and n; 1/2 of dual n-forms where hybrid stars change from one kind to the other.
INSTANTIATE_TEST_SUITE_P(Flat, FormSources,
                         testing::Values(Row{{"squares"}, 1.85, 1.45}, Row{{"triangles"}, 1.4, 1.0},
                                         Row{{"shaken_triangles"}, 1.4, 1.0},
                                         Row{{"hexagons"}, 1.5, 1.5},
                                         Row{{"shaken_triangles", 8, 16, galerkin}, 1.3, 1.0},
                                         Row{{"hexagons", 8, 16, StarKind::hybrid}, 1.0, 0.45},
                                         Row{{"hexagons", 8, 16, galerkin}, 1.0, 0.8},
                                         Row{{"cubes", 3, 5, by_duals}, 1.6, 1.4},
                                         Row{{"bcc", 2, 4, by_duals}, 1.35, 1.35},
                                         Row{{"fcc", 2, 3, by_duals}, 1.0, 1.0},
                                         Row{{"shaken_bcc", 2, 4, galerkin}, 1.3, 1.0, 1}),
                         name_of<Row>);

/// A torus, an annulus of merged quads, and a solid torus: Betti numbers 1 2 1, 1 1, 1 1.
std::vector<Mesh> with_harmonic_forms() {
    return {torus(12, 8), mesh_named("ring6"), mesh_named("solid_torus3")};
}

TEST(HarmonicPart, is_removed_from_the_source_and_given_to_the_solution) {
    int seen = 0;
    for (const Mesh& input : with_harmonic_forms()) {
        const auto mesh = discretize(input);
        for_all_forms(mesh.dimension(), [&](Side side, int k) {
            for (const auto condition :
                 {BoundaryCondition::essential, BoundaryCondition::natural}) {
                PoissonSolver solver({mesh, side, k, {condition}});
                const DenseMatrix H = solver.harmonic_forms();
                if (H.cols() == 0)
                    continue;
                ++seen;
                const Cochain h{side, k, H * Vector::LinSpaced(H.cols(), 1, 2)};
                const auto none = solver.solve(h);
                EXPECT_LE(norm(mesh, none.removed - h), 1e-9 * norm(mesh, h));
                EXPECT_LE(norm(mesh, none.form), 1e-7 * norm(mesh, h));
                const auto given = solver.solve(0.0 * h, {}, Vector::LinSpaced(H.cols(), 1, 2));
                EXPECT_LE(norm(mesh, given.form - h), 1e-9 * norm(mesh, h));
                EXPECT_GT(norm(mesh, given.form - 2.0 * h), 0.1 * norm(mesh, h));
            }
        });
    }
    EXPECT_GE(seen, 12);
}

TEST(CurlCurl, removes_what_is_no_curl_and_keeps_the_gauge) {
    auto mesh = circumcentric(kuhn(3, 4));
    const Vector permeability = Vector::LinSpaced(mesh.complex().size(3), 1, 3);
    for (const bool material : {false, true}) {
        if (material)
            mesh = mesh.with_stars(mesh.stars().with(
                2, material_star(mesh, 2, CellData::on_cells(permeability.cwiseInverse()))));
        PoissonSolver solver({mesh, Side::primal, 1, {}});
        const auto relative = relative_to_boundary(mesh.complex());
        const auto inside = [&](int k, unsigned seed) {
            return relative.extend(k, random_vector(relative.complex.size(k), seed));
        };
        const Cochain curl =
            codifferential(mesh, {Side::primal, 2, random_vector(mesh.complex().size(2), 1)});
        const Cochain gradient = d(mesh.complex(), Cochain{Side::primal, 0, inside(0, 2)});
        const auto solution = solve_curl_curl(solver, curl + gradient);
        EXPECT_LE(norm(mesh, solution.removed - gradient), 1e-8 * norm(mesh, gradient));
        const Vector left = relative.restrict(
            1, codifferential(mesh, d(mesh.complex(), solution.potential)).values - curl.values);
        EXPECT_LE(left.norm(), 1e-8 * curl.values.norm());
        const Vector gauge = relative.restrict(0, codifferential(mesh, solution.potential).values);
        EXPECT_LE(gauge.norm(), 1e-8 * curl.values.norm());
        // with Delta u = j alone the gauge is lost
        const auto whole = solver.solve(curl + gradient);
        EXPECT_GT(relative.restrict(0, codifferential(mesh, whole.form).values).norm(),
                  1e-3 * curl.values.norm());
    }
}

/// Elimination with exchanges, of the equations of primal forms and codifferentials.
TEST(FormSources, of_thin_cells_have_the_solution_of_dense_equations) {
    for (const int n : {2, 3})
        for (const double height : {1.0, 0.03, 0.003, 0.001}) {
            Mesh thin = kuhn(n, n == 2 ? 6 : 2);
            thin.points.col(n - 1) *= height;
            const auto mesh =
                discretize(thin, {.criterion = MergeCriterion::none, .star = StarKind::galerkin});
            const HodgeStars& stars = mesh.stars();
            for (int k = 1; k < n; ++k) {
                const SparseMatrix d = derivative(mesh.complex(), k),
                                   before = derivative(mesh.complex(), k - 1),
                                   M = stars[k].matrix();
                const auto size = M.rows(), all = size + before.cols();
                DenseMatrix A(all, all);
                A << DenseMatrix(d.transpose() * stars[k + 1].matrix() * d),
                    DenseMatrix(M * before), DenseMatrix(before.transpose() * M),
                    -DenseMatrix(stars[k - 1].matrix());
                const Cochain f{Side::primal, k, random_vector(Index(size), 1)};
                Vector b = Vector::Zero(all);
                b.head(size) = M * f.values;
                const Vector u = A.partialPivLu().solve(b).head(size);
                const PoissonSolver solver({mesh, Side::primal, k, {BoundaryCondition::natural}});
                EXPECT_CLOSE(solver.solve(f).form.values, u, 1e-6) << n << k << height;
            }
        }
}

TEST(FormSourceErrors, name_what_does_not_fit) {
    const auto mesh = circumcentric(grid(2, 2));
    const PoissonSolver solver({mesh, Side::primal, 1, {}});
    EXPECT_REFUSED(solver.solve({Side::primal, 0, Vector::Zero(9)}), "primal 0-form",
                   "primal 1-form");
    EXPECT_REFUSED(solver.solve({Side::primal, 1, Vector::Zero(12)}, {.flow = Vector::Zero(3)}),
                   "3 boundary values", "star", "9");
    EXPECT_REFUSED(PoissonSolver({mesh, Side::primal, 3, {}}), "primal forms", "degree 3",
                   "dimension 2", "0", "2");
}

TEST(BoundaryDeRham, completes_the_derivative_of_dual_forms) {
    for (const Mesh& input : {hexagons(5), well_centered(3), kuhn(3, 1), bcc(1)}) {
        const auto mesh = circumcentric(input);
        const int n = mesh.dimension();
        for (int j = 0; j < n; ++j) {
            const WaveForm wave(n, j, 0.7);
            const Vector inside =
                dual_derivative(mesh.complex(), j) * dual_de_rham(mesh, j, wave.form(), 9).values;
            const Vector whole = dual_de_rham(mesh, j + 1, wave.derivative(), 9).values;
            const Vector data = boundary_de_rham(mesh, j, wave.form(), 9);
            const SparseMatrix B = dual_boundary_derivative(mesh.complex(), j);
            EXPECT_CLOSE(Vector(inside + B * data), whole, 1e-7) << n << j;
            EXPECT_GT(relative_difference(Vector(inside - B * data), whole), 1e-2) << n << j;
        }
    }
}

} // namespace polydec::test::in_form_sources
