// SPDX-License-Identifier: MIT
#include "tests/solvers/cases.h"

namespace polydec::test::in_materials {

constexpr double wall = 0.5, ratio = 10;

/// Left and right of x = 1/2 are two materials; vertices near the wall are put on it.
Mesh two_materials(Mesh mesh) {
    for (Index v = 0; v < mesh.points.rows(); ++v)
        if (std::abs(mesh.points(v, 0) - wall) < 0.05)
            mesh.points(v, 0) = wall;
    for (Index t = 0; t < mesh.simplices.rows(); ++t) {
        double x = 0;
        for (const Index v : mesh.simplices.row(t))
            x += mesh.points(v, 0) / static_cast<double>(mesh.simplices.cols());
        mesh.tags.push_back(x < wall ? 1 : 2);
    }
    return mesh;
}

/// The solution whose flux is 1 everywhere.
double potential(double x) {
    return x < wall ? x : wall + (x - wall) / ratio;
}

double error(const Mesh& input, MergeCriterion criterion, Side side, double second = ratio) {
    const auto mesh =
        circumcentric(input, {.criterion = criterion, .materials = Materials::keep_apart});
    Vector conductivity(mesh.complex().size(mesh.dimension()));
    for (Index cell = 0; cell < conductivity.size(); ++cell)
        conductivity[cell] = mesh.tags()[cell] == 1 ? 1 : second;
    const auto medium = with_conductivity(mesh, side, CellData::on_cells(conductivity));
    const auto given = [](const Vector& p) { return potential(p[0]); };
    const Vector exact = at(sites(medium, side), given);
    const auto found = solved(PoissonSolver(functions(medium, side)), 0 * exact,
                              at(boundary_sites(medium, side), given));
    return (found.form.values - exact).cwiseAbs().maxCoeff();
}

constexpr double rounding = 1e-12;

TEST(TwoMaterials, have_their_exact_solution_on_cubes_of_any_dimension) {
    for (int n = 1; n <= 4; ++n) {
        const Mesh mesh = two_materials(kuhn(n, 4));
        EXPECT_LT(error(mesh, MergeCriterion::dual_length, Side::primal), rounding) << n;
        EXPECT_LT(error(mesh, MergeCriterion::dual_length, Side::dual), rounding) << n;
        EXPECT_LT(error(mesh, MergeCriterion::none, Side::primal), rounding) << n;
    }
}

TEST(TwoMaterials, have_their_exact_solution_on_triangles_of_any_shape) {
    const Mesh mesh = two_materials(perturbed(grid(8, 8), 0.01, 3));
    for (const auto criterion : {MergeCriterion::dual_length, MergeCriterion::none})
        for (const Side side : {Side::primal, Side::dual}) {
            EXPECT_LT(error(mesh, criterion, side), 1e-11);
            EXPECT_GT(error(mesh, criterion, side, 9), 1e-3) << "another conductivity";
        }
}

TEST(TwoMaterials, have_their_exact_solution_where_the_wall_divides_cospherical_cells) {
    // the hypotenuses of squares lie on the wall: across it nothing may merge
    const Mesh mesh =
        two_materials(made_of({{0.5, 0}, {1, 0.5}, {0.5, 1}, {0, 0.5}, {0, 0}, {1, 1}},
                              {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {1, 5, 2}}));
    EXPECT_LT(error(mesh, MergeCriterion::dual_length, Side::primal), rounding);
    const auto joined = circumcentric(mesh);
    EXPECT_EQ(joined.warnings().size(), 1u);
    EXPECT_LT(joined.complex().size(2),
              circumcentric(mesh, {.materials = Materials::keep_apart}).complex().size(2));
}

// 100 at x = 0, du/dnu + 2 u = 40 at x = 1, kappa 1 and then `ratio`. The twin: other air.
TEST(TwoMaterials, are_cooled_by_the_data_of_their_facets) {
    const auto plate =
        circumcentric(two_materials(kuhn(2, 4)), {.materials = Materials::keep_apart});
    Vector kappa(plate.size(2));
    for (Index cell = 0; cell < kappa.size(); ++cell)
        kappa[cell] = plate.tags()[cell] == 1 ? 1 : ratio;
    std::vector<bool> hot, air;
    const Points facets = facet_sites(plate);
    for (Index f = 0; f < facets.rows(); ++f) {
        hot.push_back(facets(f, 0) < 1e-9);
        air.push_back(facets(f, 0) > 1 - 1e-9);
    }
    const double inward = (40 - 2 * 100) / (1 + 2 * potential(1));
    for (const Side side : sides) {
        const auto medium = with_conductivity(plate, side, CellData::on_cells(kappa));
        const FormSpace space(
            medium, side, 0,
            BoundaryConditions(BoundaryCondition::natural).essential(hot).robin(air, 2));
        const Vector exact = at(sites(medium, side),
                                [&](const Vector& p) { return 100 + inward * potential(p[0]); });
        const auto error = [&](double outside) {
            const auto found = PoissonSolver(space).solve(
                space.form(0 * exact), boundary_data(space, {{hot, 100}, {air, outside}}));
            return (found.form.values - exact).cwiseAbs().maxCoeff();
        };
        EXPECT_LE(error(40), 1e-10) << name(side);
        EXPECT_GT(error(50), 1e-2) << name(side);
    }
}

// On a mesh of one material: the speed of waves is 1 / sqrt(permittivity permeability).
TEST(ElectricMaterial, divides_eigenvalues_by_permittivity_and_permeability) {
    const auto empty = circumcentric(kuhn(2, 4));
    for (const Side side : sides)
        for (const int degree : {0, 1}) {
            const auto both = [&](double permittivity, double permeability) {
                const auto cells = Vector::Ones(empty.size(2));
                const auto filled = with_electric_material(
                    empty, side, degree, CellData::on_cells(permittivity * cells),
                    CellData::on_cells(permeability * cells));
                return stable_step({filled, side, degree});
            };
            EXPECT_NEAR(both(4, 9), 6 * both(1, 1), 1e-9 * both(1, 1)) << name(side) << degree;
        }
}

} // namespace polydec::test::in_materials
