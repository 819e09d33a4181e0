// SPDX-License-Identifier: MIT
#include "tests/solvers/cases.h"
#include "tests/support/read_golden.h"
#include "tests/support/scales.h"

namespace polydec::test::in_poisson {

// Franke's function is a sum of c exp(-q). Its second term falls linearly with y, the last one has
// Franke's own exponent.
struct Bump {
    double c, a, b, s, t; ///< q = (9x - a)^2 s + (9y - b)^2 t
};
constexpr std::array<Bump, 3> bumps{
    {{0.75, 2, 2, 0.25, 0.25}, {0.5, 7, 3, 0.25, 0.25}, {-0.2, 4, 7, 1, 1}}};

double franke(const Vector& p) {
    const double x = 9 * p[0], y = 9 * p[1];
    double sum = 0.75 * std::exp(-(x + 1) * (x + 1) / 49 - (y + 1) / 10);
    for (const auto& bump : bumps)
        sum += bump.c * std::exp(-bump.s * (x - bump.a) * (x - bump.a) -
                                 bump.t * (y - bump.b) * (y - bump.b));
    return sum;
}

/// -div grad: of c exp(-q) it is c exp(-q) (div grad q - |grad q|^2).
double franke_laplacian(const Vector& p) {
    const double x = 9 * p[0], y = 9 * p[1];
    const double qx = 18 * (x + 1) / 49, qy = 0.9;
    double sum =
        0.75 * std::exp(-(x + 1) * (x + 1) / 49 - (y + 1) / 10) * (162.0 / 49 - qx * qx - qy * qy);
    for (const auto& bump : bumps) {
        const double u = x - bump.a, v = y - bump.b;
        const double gx = 18 * bump.s * u, gy = 18 * bump.t * v;
        sum += bump.c * std::exp(-bump.s * u * u - bump.t * v * v) *
               (162 * (bump.s + bump.t) - gx * gx - gy * gy);
    }
    return sum;
}

double franke_error(const Discretization& mesh, Side side) {
    const auto found =
        solved(PoissonSolver(functions(mesh, side)), at(sites(mesh, side), franke_laplacian),
               at(boundary_sites(mesh, side), franke));
    EXPECT_LE(found.report.residual, 1e-10);
    return l2_norm(mesh, side, found.form.values - at(sites(mesh, side), franke));
}

/// The errors, by an independent program, of grids with N = 8, 16, 32.
TEST(FrankesProblem, has_the_known_errors_on_grids) {
    const auto expect = [](Side side, const std::array<double, 3>& known) {
        Index N = 8;
        for (const double error : known) {
            EXPECT_NEAR(franke_error(Case{"squares"}.mesh(N), side), error, 0.05 * error) << N;
            N *= 2;
        }
    };
    expect(Side::dual, {0.0176, 0.00358, 8.73e-4});
    expect(Side::primal, {0.0182, 0.00428, 0.00105});
}

struct Row : Case {
    std::vector<Where> conditions;
    double expected = 2, tolerance = 0.1;
};

/// Of a product of cosines, a solution of Delta u = n frequency^2 u; `terms` is n, or else the
/// right-hand side belongs to another solution.
double wave_error(const Discretization& mesh, Side side, Where where, int terms) {
    const bool is_free = where == Where::natural; // whose normal derivative vanishes
    const double frequency = is_free ? M_PI : M_PI / 2, shift = is_free ? 0 : 0.3;
    const auto conditions = conditions_of(mesh, where);
    const auto wave = [=](const Points& places) -> Vector {
        return (frequency * places.array() + shift).cos().rowwise().prod();
    };
    Vector data;
    if (where == Where::mixed || where == Where::robin) {
        const Points facets = facet_sites(mesh);
        const DenseMatrix slopes = -frequency * (frequency * facets.array() + shift).tan();
        data = outward_normals(mesh).cwiseProduct(slopes).rowwise().sum();
        data += robin_coefficients(mesh.complex(), conditions);
        data = data.cwiseProduct(wave(facets));
    }
    const Vector exact = wave(sites(mesh, side));
    const auto found =
        solved(PoissonSolver(functions(mesh, side, conditions)),
               terms * frequency * frequency * exact, wave(boundary_sites(mesh, side)), data);
    return l2_norm(mesh, side, found.form.values - exact);
}

class PoissonOrders : public testing::TestWithParam<Row> {};

TEST_P(PoissonOrders, are_two_on_both_sides) {
    for (const Side side : sides)
        for (const Where where : GetParam().conditions)
            EXPECT_NEAR(order(GetParam(),
                              [&](const Discretization& mesh) {
                                  return wave_error(mesh, side, where, mesh.dimension());
                              }),
                        GetParam().expected, GetParam().tolerance)
                << name(side) << int(where);
}

const std::vector<Where> any(std::begin(everywhere), std::end(everywhere));

// Of five-dimensional cubes 2.18 is what the eigenvalues 4 sin^2(pi h / 2) / h^2 give.
INSTANTIATE_TEST_SUITE_P(Lattices, PoissonOrders,
                         testing::Values(Row{{"squares", 16, 32}, any, 2, 0.15},
                                         Row{{"hexagons", 16, 32}, any, 2, 0.15},
                                         Row{{"thin_squares", 32, 64}, {Where::essential}, 2, 0.15},
                                         Row{{"cubes", 8, 16}, {Where::essential}},
                                         Row{{"thin_cubes", 8, 16}, {Where::essential}, 2, 0.15},
                                         Row{{"split_cubes", 8, 16}, {Where::essential}},
                                         Row{{"bcc", 8, 12}, {Where::essential}},
                                         Row{{"fcc", 8, 12}, {Where::essential}},
                                         Row{{"tesseracts", 3, 6}, {Where::natural}},
                                         Row{{"d4", 3, 4}, {Where::natural}},
                                         Row{{"cubes5", 2, 3}, {Where::natural}, 2.18}),
                         name_of<Row>);

TEST(PoissonOrdersBroken, are_not_two_for_another_right_hand_side) {
    for (const Side side : sides)
        EXPECT_LT(std::abs(order({"cubes", 8, 16},
                                 [&](const Discretization& mesh) {
                                     return wave_error(mesh, side, Where::essential, 4);
                                 })),
                  1.0);
}

TEST(NaturalConditions, say_how_far_fluxes_are_from_balanced) {
    const auto& mesh = Case{"squares"}.mesh(4);
    for (const Side side : sides) {
        const PoissonSolver solver(functions(mesh, side, {BoundaryCondition::natural}));
        const Vector ones = Vector::Ones(sites(mesh, side).rows());
        // what is made inside, 4 per area, leaves through the boundary of length 4
        const Vector out = Vector::Constant(mesh.complex().size(1), -1);
        EXPECT_LE(solved(solver, 4 * ones, {}, out).compatibility.worst, 1e-12);
        EXPECT_GT(solved(solver, 5 * ones, {}, out).compatibility.worst, 0.1);
    }
}

TEST(ThinLayers, keep_linear_functions_on_both_sides_and_where_boxes_grow) {
    std::vector<Discretization> meshes{circumcentric(graded(2, 10, 1e5)),
                                       circumcentric(graded(3, 6, 3e4))};
    for (const double thickness : {1e-3, 1e-4, 1e-5, 1e-6})
        for (const int n : {2, 3})
            meshes.push_back(circumcentric(layers(n, n == 2 ? 10 : 5, thickness)));
    for (const double thickness : {1e-3, 1e-4}) // as far as lengths know angles
        meshes.push_back(circumcentric(layers(2, 10, thickness), {.delaunay = Delaunay::flips}));
    const auto linear = [](const Vector& p) {
        return 0.3 + Vector::LinSpaced(p.size(), 1.0, -2.0).dot(p);
    };
    for (const auto& mesh : meshes)
        for (const Side side : sides) {
            const Vector exact = at(sites(mesh, side), linear);
            const auto found = solved(PoissonSolver(functions(mesh, side)), 0 * exact,
                                      at(boundary_sites(mesh, side), linear));
            EXPECT_WITHIN(found.form.values, exact, 1e-12) << name(side);
        }
}

/// The component that each site belongs to.
std::vector<Index> components_of_sites(const Discretization& mesh, Side side) {
    const auto of_vertex = components(mesh.complex()).of_vertex;
    const int k = side == Side::primal ? 0 : mesh.dimension();
    std::vector<Index> result;
    for (Index i = 0; i < mesh.complex().size(k); ++i)
        result.push_back(of_vertex[mesh.merging().vertices(k, i).front()]);
    return result;
}

/// Weighted means of a solution, one for each component.
Vector means(const Discretization& mesh, Side side, const Vector& u) {
    const auto component = components_of_sites(mesh, side);
    const Vector& volume =
        side == Side::primal ? mesh.volumes().dual(0) : mesh.volumes().primal(mesh.dimension());
    Vector sum = Vector::Zero(components(mesh.complex()).count), weight = sum;
    for (Index i = 0; i < u.size(); ++i) {
        sum[component[i]] += volume[i] * u[i];
        weight[component[i]] += volume[i];
    }
    return sum.cwiseQuotient(weight);
}

double wave(const Vector& p) {
    return std::sin(3 * p[0] + 1) * p[p.size() - 1];
}

TEST(NaturalProblem, has_the_solution_of_mean_zero_on_every_component) {
    const Mesh two_squares =
        united(grid(6, 6), transformed(well_centered(3), DenseMatrix::Identity(2, 2), 1.0, 3.0));
    for (const auto& input : {two_components(), two_squares})
        for (const Side side : sides) {
            const auto mesh = circumcentric(input);
            const PoissonSolver solver(functions(mesh, side, {BoundaryCondition::natural}));
            const Vector f = at(sites(mesh, side), wave);
            const auto found = solved(solver, f);
            const Vector& u = found.form.values;
            EXPECT_GT(u.norm(), 1e-3);
            ASSERT_EQ(means(mesh, side, u).size(), 2);
            EXPECT_LE(means(mesh, side, u).cwiseAbs().maxCoeff(), 1e-12);
            EXPECT_EQ(found.compatibility.free_components, 2);
            EXPECT_GT(found.compatibility.worst, 1e-3) << "f has means that are not zero";

            // the means of f are what was removed, so without them nothing changes
            const Vector rest = f - means(mesh, side, f)(components_of_sites(mesh, side));
            const auto again = solved(solver, rest);
            EXPECT_LE((again.form.values - u).norm(), 1e-10 * u.norm());
            EXPECT_LE(again.compatibility.worst, 1e-12);
        }
}

TEST(ClosedSurface, has_no_use_for_boundary_data) {
    const auto mesh = circumcentric(torus(16, 8));
    for (const Side side : sides) {
        const PoissonSolver natural(functions(mesh, side, {BoundaryCondition::natural}));
        const Vector f = at(sites(mesh, side), wave);
        const auto found = solved(PoissonSolver(functions(mesh, side)), f,
                                  Vector::Ones(boundary_sites(mesh, side).rows()));
        const Vector& u = found.form.values;
        EXPECT_TRUE(u.isApprox(solved(natural, f).form.values, 1e-12));
        EXPECT_LE(means(mesh, side, u).cwiseAbs().maxCoeff(), 1e-12);
        EXPECT_EQ(found.compatibility.free_components, 1);
    }
}

std::string dual_refusal(const Mesh& mesh) {
    return refusal([&] { PoissonSolver(functions(circumcentric(mesh), Side::dual)); });
}

TEST(DualProblemRefuses, what_has_not_two_sides) {
    EXPECT_SAYS(dual_refusal(moebius(12, 2)), "non-orientable", "dual 0-forms", "facet 0",
                "vertices 0, 1");
    EXPECT_SAYS(dual_refusal(read_golden("branching.off")), "3 cells", "facet 0", "vertices 0, 1",
                "flux");
}

TEST(DualProblemRefuses, interior_facets_without_dual) {
    const auto mesh = circumcentric(grid(2, 2), {.criterion = MergeCriterion::none});
    EXPECT_REFUSED(PoissonSolver(functions(mesh, Side::dual)), "dual", "facet 2", "vertices 0, 4",
                   "length");
}

TEST(PrimalProblem, needs_no_two_sides) {
    for (const auto& input : {moebius(12, 2), read_golden("branching.off")}) {
        const auto mesh = circumcentric(input);
        const Vector ones = Vector::Ones(mesh.complex().size(0));
        const auto found = solved(PoissonSolver(functions(mesh, Side::primal)), 0 * ones, ones);
        EXPECT_WITHIN(found.form.values, ones, 1e-12);
    }
}

TEST(PoissonSolverRefuses, data_that_are_no_numbers_or_too_few) {
    const auto mesh = circumcentric(grid(2, 2));
    const PoissonSolver solver(functions(mesh, Side::primal));
    const Vector zeros = Vector::Zero(9);
    Vector bad = zeros;
    bad[4] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_REFUSED(solved(solver, bad), "primal 0-form", "4", "nan");
    bad[4] = std::numeric_limits<double>::infinity();
    EXPECT_REFUSED(solved(solver, zeros, bad), "boundary values of the form", "4", "inf");
    EXPECT_REFUSED(solved(solver, Vector::Zero(8)), "primal 0-form", "8 values", "9 0-cells");
    EXPECT_REFUSED(solved(solver, zeros, Vector::Zero(10)), "10 boundary values", "expected 9");
    EXPECT_REFUSED(solved(solver, zeros, zeros, zeros), "9 outward derivatives", "expected 12");
    EXPECT_REFUSED(functions(mesh, Side::primal,
                             {BoundaryCondition::essential, {2, BoundaryCondition::natural}}),
                   "2 boundary conditions", "12 1-cells");
}

TEST(PoissonSolverRefuses, data_that_overflow_with_the_volumes) {
    const auto mesh = circumcentric(grid(2, 2));
    for (const Side side : sides) {
        const PoissonSolver solver(functions(mesh, side));
        const Vector f = Vector::Zero(sites(mesh, side).rows());
        const Vector values = Vector::Constant(boundary_sites(mesh, side).rows(), -1.5e308);
        EXPECT_REFUSED(solved(solver, f, values), "right-hand side",
                       side == Side::primal ? "0-cell 4" : "2-cell 0", "-inf");
        EXPECT_TRUE(solved(solver, f, values / 16).form.values.allFinite());
    }
}

TEST(PoissonByStars, makes_the_star_of_conductivities) {
    const auto mesh = discretize(shaken(kuhn(3, 2), 0.25, 3));
    ASSERT_EQ(mesh.chosen_stars().kind, StarKind::galerkin);
    Vector kappa(mesh.complex().size(3));
    for (Index cell = 0; cell < kappa.size(); ++cell)
        kappa[cell] = 1 + cell % 3;
    for (const Side side : sides) {
        const int k = side == Side::primal ? 1 : 2;
        const Vector weights = side == Side::primal ? kappa : Vector(kappa.cwiseInverse());
        const auto own = mesh.with_stars(
            mesh.stars().with(k, material_star(mesh, k, CellData::on_cells(weights))));
        const auto solve = [&](const Discretization& given) {
            return solved(PoissonSolver(functions(given, side)),
                          Vector::Ones(sites(given, side).rows()),
                          boundary_sites(given, side).col(0))
                .form.values;
        };
        const auto made = with_conductivity(mesh, side, CellData::on_cells(kappa));
        EXPECT_EQ(solve(made), solve(own));
        EXPECT_GT(relative_difference(solve(made), solve(mesh)), 1e-5);
    }
}

} // namespace polydec::test::in_poisson
