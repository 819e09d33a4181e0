// SPDX-License-Identifier: MIT
//
// Delta u = 1 with u = 0 on the boundary, on tetrahedra with negative duals: u is nowhere negative.
#include "tests/real/samples.h"

namespace polydec::test::in_poisson_tets {

class RealTets : public testing::TestWithParam<std::string> {
protected:
    static Discretization mesh(StarKind kind) {
        const auto mesh = discretize(mesh_of(GetParam()));
        return mesh.with_stars(mesh.with_stars(kind).stars());
    }

    /// The least value over the largest.
    static double least(StarKind kind, Side side) {
        const PoissonSolver solver({mesh(kind), side, 0, {BoundaryCondition::essential}});
        const Vector ones = Vector::Ones(mesh(kind).complex().size(solver.space().cell_degree()));
        const Vector u = solver.solve({side, 0, ones}).form.values;
        return u.minCoeff() / u.maxCoeff();
    }
};

TEST_P(RealTets, have_positive_solutions_by_galerkin) {
    EXPECT_GE(least(StarKind::galerkin, Side::primal), 0);
    // mixed elements have no maximum principle: 8 of the 30 k cells of `hand` fall below 0 by this
    EXPECT_GE(least(StarKind::galerkin, Side::dual), -1e-3);
    EXPECT_LT(least(StarKind::circumcentric, Side::dual), -0.05);
}

TEST_P(RealTets, part_forms_by_galerkin) {
    const auto tets = mesh(StarKind::galerkin);
    for (const int k : {1, 2}) {
        const HodgeStar star = tets.stars()[k];
        const Vector w = random_vector(star.size(), 1);
        const auto parts = HodgeSolver({tets, Side::primal, k}).decompose({Side::primal, k, w});
        const auto product = [&](const Cochain& a, const Cochain& b) {
            return std::abs(a.values.dot(star * b.values)) / w.dot(star * w);
        };
        EXPECT_LE(product(parts.exact, parts.coexact), 1e-10) << "k = " << k;
        EXPECT_LE(product(parts.exact, parts.harmonic), 1e-10) << "k = " << k;
        EXPECT_LE(product(parts.coexact, parts.harmonic), 1e-10) << "k = " << k;
        EXPECT_GT(product(parts.exact, parts.exact), 1e-3);
    }
}

INSTANTIATE_TEST_SUITE_P(Real, RealTets,
                         testing::ValuesIn(samples(3, {"tet/octopus-low.mesh",
                                                       "tet/test_mesh_3d.msh", "tet/hand.mesh"})),
                         [](const auto& instance) { return test_name(instance.param); });

} // namespace polydec::test::in_poisson_tets
