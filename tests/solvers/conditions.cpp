// SPDX-License-Identifier: MIT
#include "tests/solvers/cases.h"

namespace polydec::test::in_conditions {

const BoundaryConditions dirichlet{BoundaryCondition::essential};
const BoundaryConditions neumann{BoundaryCondition::natural};

/// Every square of an m x m grid of the unit square cut into four by its diagonals.
Mesh crossed_squares(int m) {
    Mesh mesh;
    const Index corners = (m + 1) * (m + 1);
    mesh.points.resize(corners + m * m, 2);
    mesh.simplices.resize(4 * m * m, 3);
    for (int i = 0; i <= m; ++i)
        for (int j = 0; j <= m; ++j)
            mesh.points.row(i * (m + 1) + j) << double(i) / m, double(j) / m;
    for (int i = 0; i < m; ++i)
        for (int j = 0; j < m; ++j) {
            const Index a = i * (m + 1) + j, b = a + m + 1, middle = corners + i * m + j;
            mesh.points.row(middle) << (i + 0.5) / m, (j + 0.5) / m;
            mesh.simplices.middleRows(4 * (i * m + j), 4) << a, b, middle, b, b + 1, middle, b + 1,
                a + 1, middle, a + 1, a, middle;
        }
    return mesh;
}

Mesh in_single_precision(Mesh mesh) {
    mesh.points = mesh.points.cast<float>().cast<double>();
    return mesh;
}

double first_eigenvalue(const Mesh& input, Side side, const BoundaryConditions& conditions) {
    return spectrum({circumcentric(input), side, 0, conditions}, {.count = 1}).eigenvalues[0];
}

/// On the left of the boundary values are 0; no facet is near the place where that ends.
BoundaryConditions left_part(const Discretization& mesh) {
    const Points sites = cell_centers(mesh, mesh.dimension() - 1);
    const double first = sites.col(0).minCoeff(), last = sites.col(0).maxCoeff();
    const double end = first + 0.371 * (last - first);
    return essential_where(sites, [=](const Vector& site) { return site[0] < end; });
}

TEST(CrossedSquares, have_one_dual_spectrum_exact_jittered_and_in_single_precision) {
    const Mesh exact = crossed_squares(10);
    ASSERT_EQ(circumcentric(exact).degenerate().boundary, 40);
    EXPECT_NEAR(first_eigenvalue(exact, Side::dual, dirichlet), 19.5774, 5e-5);
    for (const auto& other : {perturbed(exact, 1e-7, 1), perturbed(exact, 1e-7, 2),
                              in_single_precision(exact), perturbed(exact, 1e-12, 3)})
        EXPECT_NEAR(first_eigenvalue(other, Side::dual, dirichlet), 19.5774, 5e-5);
    // dual 0-forms have Dirichlet's condition by themselves
    const auto mesh = circumcentric(exact);
    EXPECT_NEAR(spectrum({mesh, Side::dual, 0}, {.count = 1}).eigenvalues[0], 19.5774, 5e-5);
}

/// Right angles opposite to boundary facets, in several dimensions; well-shaped otherwise.
std::vector<Mesh> with_centers_on_the_boundary() {
    return {crossed_squares(6), hexagons(5), fcc(2), mesh_named("fcc1"), mesh_named("hex4")};
}

/// The solver of the Poisson problem knows eigenfunctions, and eigenvalues those of its matrix.
TEST(DualSpectra, have_the_modes_of_the_Poisson_problem_under_the_same_conditions) {
    for (const auto& input : with_centers_on_the_boundary()) {
        const auto mesh = circumcentric(input);
        ASSERT_GT(mesh.degenerate().boundary, 0);
        for (const auto& conditions : {dirichlet, left_part(mesh)}) {
            const auto found = spectrum({mesh, Side::dual, 0, conditions}, {.count = 4});
            const PoissonSolver poisson({mesh, Side::dual, 0, conditions});
            for (Index i = 0; i < 4; ++i) {
                const Cochain mode{Side::dual, 0, found.modes.col(i)};
                const auto error = [&](double factor) {
                    const Cochain u = poisson.solve(factor * found.eigenvalues[i] * mode).form;
                    return relative_difference(u.values, mode.values);
                };
                EXPECT_LE(error(1), 1e-8) << i;
                EXPECT_GT(error(2), 0.5);
            }
            // cells whose centers lie on the essential boundary have the value 0
            EXPECT_GT((found.modes.col(0).array() == 0).count(), 0);
        }
    }
}

TEST(DualSpectra, with_values_on_a_part_of_the_boundary_do_not_mind_jitter) {
    for (const auto& input : with_centers_on_the_boundary()) {
        const auto values = [](const Mesh& mesh) {
            const auto bundle = circumcentric(mesh);
            return spectrum({bundle, Side::dual, 0, left_part(bundle)}, {.count = 3}).eigenvalues;
        };
        const Vector exact = values(input);
        EXPECT_GT(exact[0], 0);
        EXPECT_CLOSE(values(perturbed(input, 1e-8, 4)), exact, 1e-5);
        EXPECT_CLOSE(values(in_single_precision(input)), exact, 1e-5);
    }
}

TEST(DualSpectra, without_flow_have_the_constants_at_0) {
    for (const auto& input : with_centers_on_the_boundary()) {
        const auto mesh = circumcentric(input);
        const auto found = spectrum({mesh, Side::dual, 0, neumann}, {.count = 2});
        EXPECT_NEAR(found.eigenvalues[0], 0, 1e-9 * found.eigenvalues[1]);
        EXPECT_GT(found.eigenvalues[1], 0.1);
        const Vector mode = found.modes.col(0);
        const Vector& volumes = mesh.volumes().primal(mesh.dimension());
        EXPECT_LE((mode.array() - mode[0]).abs().maxCoeff(), 1e-8 * std::abs(mode[0]));
        EXPECT_NEAR(volumes.dot(mode.cwiseAbs2()), 1, 1e-9);
    }
}

TEST(Conditions, of_both_sides_lead_to_the_same_eigenvalues) {
    // exact: 2 pi^2, 0, and pi^2 / 4 for values on one side of the unit square
    const double squared = M_PI * M_PI;
    const Mesh square = grid(24, 24);
    const auto mesh = circumcentric(square);
    const auto one_side =
        essential_where(cell_centers(mesh, 1), [](const Vector& site) { return site[0] < 1e-9; });
    for (const Side side : sides) {
        EXPECT_NEAR(first_eigenvalue(square, side, dirichlet), 2 * squared, 0.01 * squared);
        EXPECT_NEAR(first_eigenvalue(square, side, neumann), 0, 1e-8);
        EXPECT_NEAR(first_eigenvalue(square, side, one_side), squared / 4, 0.002 * squared);
        EXPECT_EQ(spectrum({mesh, side, 0}, {.count = 1}).eigenvalues[0],
                  first_eigenvalue(square, side, built_in_conditions(side)));
    }
}

TEST(Conditions, exchange_with_the_star) {
    for (const char* name : {"grid4", "ring6", "kuhn3", "solid_torus3", "kuhn4"}) {
        const auto mesh = circumcentric(mesh_named(name));
        const int n = mesh.dimension();
        for (int k = 0; k <= n; ++k)
            for (const auto& conditions : {dirichlet, neumann, left_part(mesh)}) {
                const FormSpace space(mesh, Side::primal, 0, conditions);
                const Index count = std::min<Index>(2, space.inside().complex().size(k));
                if (count == 0)
                    continue;
                const auto values = [&](Side side, int degree, const BoundaryConditions& those) {
                    return spectrum({mesh, side, degree, those}, {.count = count}).eigenvalues;
                };
                const Vector primal = values(Side::primal, k, conditions);
                const Vector dual = values(Side::dual, n - k, exchanged(conditions));
                EXPECT_WITHIN(primal, dual, 1e-8 * (1 + primal.cwiseAbs().maxCoeff()))
                    << name << ' ' << k;
            }
    }
}

TEST(HeatUnderConditions, makes_modes_decay_with_their_eigenvalues) {
    for (const auto& input : with_centers_on_the_boundary()) {
        const auto mesh = circumcentric(input);
        for (const Side side : sides)
            for (const auto& conditions : {dirichlet, neumann, left_part(mesh)}) {
                const FormSpace space(mesh, side, 0, conditions);
                if (space.size() < 2)
                    continue; // fcc1 has one vertex inside, at most
                const auto modes = spectrum(space, {.count = 2});
                const double dt = 1e-3;
                const Cochain mode{side, 0, modes.modes.col(1)};
                const Vector expected = mode.values / (1 + dt * modes.eigenvalues[1]);
                EXPECT_CLOSE(heated(space, mode, dt).values, expected, 1e-8);
                // values that the conditions fix are 0, whatever they were
                const Cochain ones{side, 0, Vector::Ones(mode.values.size())};
                const Vector next = heated(space, ones, dt).values;
                if (conditions.facets.empty() && conditions.everywhere == neumann.everywhere)
                    EXPECT_LE((next.array() - 1).abs().maxCoeff(), 1e-10);
                else
                    EXPECT_LT(next.minCoeff(), 0.99);
            }
    }
}

/// On the complex of the conditions the gradients of modes are modes of dual 1-forms.
TEST(DualSpectra, of_1_forms_have_those_of_functions_among_them) {
    for (const auto& input : with_centers_on_the_boundary()) {
        const auto mesh = circumcentric(input);
        const auto of_degree = [&](int degree, Index count) {
            return spectrum({mesh, Side::dual, degree}, {.count = count}).eigenvalues;
        };
        const double first = of_degree(0, 1)[0];
        const Vector values = of_degree(1, 12);
        EXPECT_LE((values.array() - first).abs().minCoeff(), 1e-8 * first);
        EXPECT_GT(values[0], 1e-6 * first); // balls have no harmonic forms that vanish outside
    }
}

/// Where the mechanism does not find them, what is inverted means nothing.
TEST(DualSpectraBroken, with_the_duals_of_centers_on_the_boundary_make_no_sense) {
    const auto exact = circumcentric(crossed_squares(10));
    const auto first = [](const Cells& cells) {
        return spectrum({cells, Side::dual, 0}, {.count = 1}).eigenvalues;
    };
    EXPECT_EQ(first({exact.complex(), exact.volumes()}), first(exact));
    const auto moved = circumcentric(perturbed(crossed_squares(10), 1e-7, 1), {.tolerance = 0});
    EXPECT_LT(first({moved.complex(), moved.volumes()})[0], -1e6);
}

TEST(ConditionedErrors, name_cells_by_their_numbers_in_the_mesh) {
    // the diagonals, of which none is on the boundary
    const auto mesh = circumcentric(grid(4, 4), {.criterion = MergeCriterion::none});
    const auto zero = star(mesh.volumes(), 1).zeros();
    const auto cells = "(cells " + star(mesh.volumes(), 1).numbers(zero) + ")";
    const auto ones = [&](int k) { return Vector(Vector::Ones(mesh.complex().size(k))); };
    for (const Side side : sides) {
        // by which the boundary is left out
        const auto& conditions = side == Side::primal ? dirichlet : neumann;
        const Cells inside = FormSpace(mesh, side, 0, conditions).inside();
        ASSERT_LT(inside.complex().size(1), mesh.complex().size(1));
        ASSERT_NE(star(inside, 1).zeros(), zero);
        const int of_faces = side == Side::primal ? 2 : 0;
        EXPECT_REFUSED(spectrum({mesh, side, 1, conditions}), cells);
        EXPECT_REFUSED(heated({mesh, side, 1, conditions}, {side, 1, ones(1)}, 1), cells);
        EXPECT_REFUSED(heated({mesh, side, of_faces, conditions}, {side, of_faces, ones(2)}, 1),
                       cells);
        EXPECT_REFUSED(HodgeSolver({mesh, side, 1, conditions}), cells);
    }
}

TEST(ConditionedErrors, name_the_facet_where_dual_functions_have_no_differences) {
    const auto branching = circumcentric(mesh_named("branching"));
    const auto primal = spectrum({branching, Side::primal, 0}, {.count = 2});
    EXPECT_LE(std::abs(primal.eigenvalues[0]), primal.radii[0]);
    const Vector ones = Vector::Ones(branching.complex().size(2));
    const Words words{"3 cells", "facet", "primal 0-forms"};
    EXPECT_REFUSED(spectrum({branching, Side::dual, 0}), words);
    EXPECT_REFUSED(spectrum({branching, Side::dual, 0, neumann}), words);
    EXPECT_REFUSED(heated({branching, Side::dual, 0, neumann}, {Side::dual, 0, ones}, 1), words);
}

TEST(ConditionedErrors, know_the_mesh_through_several_relative_complexes) {
    const auto mesh = circumcentric(grid(4, 4), {.criterion = MergeCriterion::none});
    const auto inside = relative_to_boundary(mesh.complex());
    const auto volumes = relative_volumes(inside, mesh.volumes());
    CellMarks marks = no_marks(inside.complex);
    marks[0][0] = true;
    const auto rest = relative_complex(inside.complex, marks);
    const auto rest_volumes = relative_volumes(rest, volumes).with_dual(2, Vector::Ones(32));
    for (int k = 0; k <= 2; ++k)
        for (Index cell = 0; cell < rest.complex.size(k); ++cell)
            EXPECT_EQ(rest_volumes.number(k, cell), inside.cells[k][rest.cells[k][cell]]);
    EXPECT_EQ(mesh.volumes().number(1, 7), 7);
    EXPECT_THROW(mesh.volumes().numbered({}), InvalidInput);
}

TEST(ConditionedErrors, of_waves_name_the_edge_of_the_mesh) {
    // two flat triangles in a ring, whose vertices come first
    // clang-format off
    const Mesh ring = made_of(
        {{-3, -3}, {3, -3}, {3, 3}, {-3, 3}, {-1, 0}, {1, 0}, {0, 0.5}, {0, -0.5}},
        {{4, 5, 6}, {4, 7, 5}, {0, 7, 4}, {0, 1, 7}, {1, 5, 7}, {1, 2, 5}, {2, 6, 5}, {2, 3, 6},
         {3, 4, 6}, {3, 0, 4}});
    // clang-format on
    const auto mesh = circumcentric(ring);
    const auto inside = relative_to_boundary(mesh.complex());
    const auto volumes = relative_volumes(inside, mesh.volumes());
    const auto negative = star(volumes, 1).negatives();
    ASSERT_EQ(negative.size(), 1U);
    const Index edge = inside.cells[1][negative[0]];
    EXPECT_EQ(cell_vertices(mesh, 1, edge), (std::vector<Index>{4, 5}));
    EXPECT_NE(edge, negative[0]);
    EXPECT_REFUSED(stable_step({{inside.complex, volumes}, Side::primal, 0}), "1 1-cells",
                   "negative", "cell " + std::to_string(edge), "StarKind::automatic");
}

/// Whether the mesh has a spectrum on these forms: it is refused or comes out.
bool has_spectrum(const Discretization& mesh, Side side, int degree) {
    return refusal([&] {
               spectrum({mesh, side, degree}, {.count = 1, .certification = Certification::waived});
           }) == "accepted";
}

void expect_verdicts_that_hold(const Discretization& mesh) {
    const int n = mesh.dimension();
    for (const Side side : sides)
        for (const auto& verdict : spectrum_verdicts(mesh, side)) {
            const int degree = side == Side::primal ? verdict.cell_degree : n - verdict.cell_degree;
            EXPECT_EQ(verdict.exists, has_spectrum(mesh, side, degree))
                << name(side) << ' ' << degree << ": " << verdict.reason;
        }
}

class VerdictsOnSpectra : public OverMeshes {};

TEST_P(VerdictsOnSpectra, say_what_spectrum_does) {
    for (const auto criterion : {MergeCriterion::none, MergeCriterion::dual_length})
        expect_verdicts_that_hold(circumcentric(mesh_named(GetParam()), {.criterion = criterion}));
}

POLYDEC_OVER_MESHES(VerdictsOnSpectra);

TEST(VerdictsOnSpectra, do_without_the_duals_of_boundary_facets_as_dual_functions_do) {
    for (const int m : {1, 2, 4}) {
        const auto mesh = circumcentric(crossed_squares(m));
        expect_verdicts_that_hold(mesh);
        // of one square every triangle has its circumcenter on the boundary
        const auto verdicts = spectrum_verdicts(mesh, Side::dual);
        EXPECT_EQ(verdicts[2].exists, m > 1);
        if (m > 1) {
            EXPECT_EQ(verdicts[2].reason, "");
        } else {
            EXPECT_SAYS(verdicts[2].reason, "no 2-cell", "value");
        }
        EXPECT_EQ(spectrum_verdicts(mesh, Side::primal)[2].exists, m > 1);
        EXPECT_FALSE(spectrum_verdicts(mesh, Side::primal)[1].exists);
    }
}

TEST(HodgeUnderConditions, sees_the_homology_of_the_dual_complex) {
    // values 0 on the boundary of a square: no harmonic dual function, one harmonic dual 2-form
    const auto mesh = circumcentric(crossed_squares(4));
    EXPECT_EQ(harmonic_forms({mesh, Side::dual, 0, dirichlet}).cols(), 0);
    EXPECT_EQ(harmonic_forms({mesh, Side::dual, 1, dirichlet}).cols(), 0);
    EXPECT_EQ(harmonic_forms({mesh, Side::dual, 2, dirichlet}).cols(), 1);
    EXPECT_EQ(harmonic_forms({mesh, Side::dual, 0, neumann}).cols(), 1);
}

} // namespace polydec::test::in_conditions
