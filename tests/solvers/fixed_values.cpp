// SPDX-License-Identifier: MIT
#include "tests/solvers/cases.h"

namespace polydec::test::in_fixed_values {

const BoundaryConditions neumann{BoundaryCondition::natural};

TEST(Conditions, fix_values_of_primal_functions_at_vertices) {
    const auto mesh = discretize(grid(8, 8));
    BoundaryConditions conditions = neumann;
    conditions.fixed_vertices.assign(mesh.complex().size(0), false);
    Vector given = Vector::Zero(mesh.complex().size(0));
    for (Index v = 0; v < given.size(); ++v) {
        const auto p = mesh.points().row(v);
        const bool is_center = p[0] == 0.5 && p[1] == 0.5;
        const bool is_corner = p[0] * (1 - p[0]) == 0 && p[1] * (1 - p[1]) == 0;
        conditions.fixed_vertices[v] = is_center || is_corner;
        given[v] = is_center ? 1 : 0;
    }
    const Vector u =
        solved(PoissonSolver(functions(mesh, Side::primal, conditions)), 0 * given, given)
            .form.values;
    const Vector flow = symmetric_laplacian(mesh, 0).matrix() * u;
    for (Index v = 0; v < given.size(); ++v)
        if (conditions.fixed_vertices[v])
            EXPECT_EQ(u[v], given[v]);
        else
            EXPECT_NEAR(flow[v], 0, 1e-12);
    EXPECT_GT(spectrum({mesh, Side::primal, 0, conditions}, {.count = 1}).eigenvalues[0], 0.1);
    for (const auto& refused : {refusal([&] {
                                    PoissonSolver({mesh, Side::dual, 0, conditions});
                                }),
                                refusal([&] {
                                    spectrum({mesh, Side::primal, 1, conditions});
                                }),
                                refusal([&] {
                                    spectrum({mesh, Side::dual, 2, conditions});
                                })})
        EXPECT_SAYS(refused, "vertices", "primal 0-forms") << refused;
    conditions.fixed_vertices.pop_back();
    EXPECT_REFUSED(functions(mesh, Side::primal, conditions), "80", "fixed vertices", "81");
}

TEST(Conditions, that_give_values_nowhere_are_found) {
    const auto mesh = discretize(grid(4, 4));
    BoundaryConditions inside = neumann;
    const auto require = [&](const BoundaryConditions& conditions, const NamedData& data) {
        require_use(boundary_counts(mesh.complex(), conditions), data);
    };
    const auto& cofaces = mesh.complex().coface_counts(1);
    for (const Index count : cofaces)
        inside.facets.push_back(count == 2 ? BoundaryCondition::essential
                                           : BoundaryCondition::natural);
    EXPECT_REFUSED(require(inside, {.values = "the wall"}), "the wall", "none", "16");
    inside.facets[std::find(cofaces.begin(), cofaces.end(), 1) - cofaces.begin()] =
        BoundaryCondition::essential;
    require(inside, {.values = "the wall"});
    const BoundaryConditions all{BoundaryCondition::essential};
    EXPECT_REFUSED(require(all, {.flow = "the inflow"}), "the inflow", "none", "16", "expected");
    EXPECT_REFUSED(require(all, {.robin = "alpha"}), "alpha", "none", "16");
    EXPECT_REFUSED(require(neumann, {.values = "the wall"}), "the wall", "none", "16", "expected",
                   "fixed vertex");
    require(all, {.values = "the wall"});
    require(neumann, {.flow = "the inflow"});
    require(inside, {.values = "the wall", .flow = "the inflow"});
    const FormSpace closed(discretize(icosphere(2)), Side::primal, 0);
    closed.require_use({.values = "on no boundary", .flow = "on no boundary"});
}

} // namespace polydec::test::in_fixed_values
