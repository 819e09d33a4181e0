// SPDX-License-Identifier: MIT
// One equation in several ways: functions by values, densities or fluxes, and as all forms.
#include "solvers/sources/poisson_system.h"
#include "tests/solvers/cases.h"

namespace polydec::test::in_poisson_systems {

/// How far forms, what was removed, and fluxes differ, but for those through facets without dual,
/// which densities alone know, from the balance of the cell beside them.
double difference(const FormSpace& space, const PoissonSystem::Found& found,
                  const PoissonSystem::Found& expected) {
    const double size = expected.form.norm() + expected.removed.norm() + 1e-9;
    Vector fluxes = found.flux - expected.flux;
    const int facets = space.cell_degree() - 1;
    for (Index f = 0; f < fluxes.size(); ++f)
        if (space.left_out()[facets][f] && !space.fixed()[facets][f])
            fluxes[f] = 0;
    return ((found.form - expected.form).norm() + (found.removed - expected.removed).norm()) /
               size +
           fluxes.norm() / (expected.flux.norm() + size);
}

/// The mesh, and the same with another material in every n-cell: the star of n-forms is not then
/// one over their volumes.
std::vector<Discretization> with_and_without_material(const Discretization& mesh) {
    const int n = mesh.dimension();
    const Vector weights = random_vector(mesh.size(n), 8).array().exp();
    return {mesh, with_material(mesh, n, CellData::on_cells(weights))};
}

// The twins: another source, and data of the opposite sign.
TEST(PoissonSystems, have_the_solution_of_the_equations_of_all_forms) {
    int seen = 0;
    const auto check = [&seen](const FormSpace& space) {
        const Cells cells = space.cells();
        const int k = space.cell_degree(), n = cells.dimension();
        if (k > 0 && k < n)
            return;
        const Vector f = random_vector(cells.complex().size(k), 7);
        const BoundaryForms data = random_data(cells.complex(), space.side(), space.degree());
        std::unique_ptr<const PoissonSystem> forms;
        const auto refused = refusal([&] { forms = system_of_forms(space, "auto"); });
        if (refused != "accepted") // stars that are not positive, which functions may have
            return;
        const auto expected = forms->solve(f, data, {});
        const DenseMatrix constants = forms->harmonic_forms().cwiseAbs();
        const auto agree = [&](const PoissonSystem& system) {
            EXPECT_LE((system.harmonic_forms() - constants).norm(), 1e-9);
            EXPECT_LE(difference(space, system.solve(f, data, {}), expected), 1e-8);
            EXPECT_GT(difference(space, system.solve(2 * f, data, {}), expected), 1e-3);
            ++seen;
        };
        if (k == 0)
            agree(*system_of_values(space, "auto"));
        else if (cells.stars()[n - 1].is_diagonal())
            agree(*system_of_densities(space, "auto"));
        const auto& left_out = space.left_out()[n];
        if (k == n && std::find(left_out.begin(), left_out.end(), true) == left_out.end())
            agree(*system_of_fluxes(space, "auto"));
    };
    for (const StarKind star : {StarKind::circumcentric, StarKind::galerkin})
        for (Case cells : {Case{"interval", 5},
                           {"squares", 4},
                           {"hexagons", 4},
                           {"triangles", 4},
                           {"cubes", 2},
                           {"bcc", 2}}) {
            cells.star = star;
            SCOPED_TRACE(cells.name());
            for (const auto& mesh : with_and_without_material(cells.mesh(cells.coarse)))
                for_all_conditions(mesh.dimension(), [&](Side side, int degree, Where where) {
                    check({mesh, side, degree, conditions_of(mesh, where)});
                });
        }
    EXPECT_GT(seen, 300);
}

/// Areas of vertices, some negative, have the area of the mesh as their sum.
TEST(PoissonSystems, of_functions_remove_constants_where_areas_are_signed) {
    const Mesh triangle{DenseMatrix{{0, 0}, {4, 0}, {2, 0.5}}, Simplices{{0, 1, 2}}, {}};
    for (const Mesh& input : {triangle, obtuse_planar(), obtuse_solid()}) {
        const auto mesh = circumcentric(input, {.criterion = MergeCriterion::none});
        const HodgeStar star = mesh.stars()[0];
        const Vector ones = Vector::Ones(star.size());
        EXPECT_LT(star.diagonal().minCoeff(), 0);
        for (const Side side : sides) {
            const bool primal = side == Side::primal;
            const int degree = primal ? 0 : mesh.dimension();
            const PoissonSolver solver(
                {mesh,
                 side,
                 degree,
                 {primal ? BoundaryCondition::natural : BoundaryCondition::essential}});
            const Cochain one{side, degree, primal ? ones : star * ones};
            const DenseMatrix H = solver.harmonic_forms();
            ASSERT_EQ(H.cols(), 1);
            const Cochain h{side, degree, H.col(0)};
            EXPECT_NEAR(inner_product(mesh, h, h), 1, 1e-12);
            const auto of_one = solver.solve(one);
            EXPECT_LE(of_one.form.values.norm(), 1e-9 * one.values.norm());
            EXPECT_CLOSE(of_one.removed.values, one.values, 1e-9);
            const Cochain f{side, degree, random_vector(star.size(), 3)};
            const auto found = solver.solve(f);
            EXPECT_NEAR(inner_product(mesh, found.form, h), 0, 1e-9 * found.form.values.norm());
            EXPECT_NEAR(inner_product(mesh, f - found.removed, h), 0, 1e-9 * f.values.norm());
        }
    }
}

} // namespace polydec::test::in_poisson_systems
