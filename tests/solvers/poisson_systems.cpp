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

// The twins: another source, and data of the opposite sign.
TEST(PoissonSystems, have_the_solution_of_the_equations_of_all_forms) {
    int seen = 0;
    for (const StarKind star : {StarKind::circumcentric, StarKind::galerkin})
        for (Case cells : {Case{"interval", 5},
                           {"squares", 4},
                           {"hexagons", 4},
                           {"triangles", 4},
                           {"cubes", 2},
                           {"bcc", 2}}) {
            cells.star = star;
            const Discretization& mesh = cells.mesh(cells.coarse);
            SCOPED_TRACE(cells.name());
            for_all_conditions(mesh.dimension(), [&](Side side, int degree, Where where) {
                const FormSpace space(mesh, side, degree, conditions_of(mesh, where));
                const int k = space.cell_degree(), n = mesh.dimension();
                if (k > 0 && k < n)
                    return;
                const Vector f = random_vector(mesh.complex().size(k), 7);
                const BoundaryForms data = random_data(mesh.complex(), side, degree);
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
                else if (mesh.stars()[n - 1].is_diagonal())
                    agree(*system_of_densities(space, "auto"));
                const auto& left_out = space.left_out()[n];
                if (k == n && std::find(left_out.begin(), left_out.end(), true) == left_out.end())
                    agree(*system_of_fluxes(space, "auto"));
            });
        }
    EXPECT_GT(seen, 150);
}

} // namespace polydec::test::in_poisson_systems
