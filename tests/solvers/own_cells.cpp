// SPDX-License-Identifier: MIT
#include "tests/dec/discretized.h"
#include "tests/solvers/cases.h"

namespace polydec::test::in_own_cells {

/// Solvers on complex and volumes alone, against those of a mesh that has these.
class OwnCells : public OverMeshes {
protected:
    const Discretization& whole() const { return discretized(GetParam()); }
    const CellComplex& complex() const { return whole().complex(); }
    const CellVolumes& volumes() const { return whole().volumes(); }

    PoissonSolution any_solution(const Cells& cells, Side side, BoundaryCondition condition) const {
        const int k = side == Side::primal ? 0 : complex().dimension();
        return solved(PoissonSolver(functions(cells, side, {condition})),
                      random_vector(complex().size(k), 1),
                      random_vector(complex().size(std::max(0, k - 1)), 2));
    }

    /// What a mesh and its own cells answer is the same, or both refuse. The twin: times a factor.
    template <class Question>
    void expect_equal(double factor, Question ask) const {
        Vector a, b;
        const auto one = message_of<Error>([&] { a = ask(whole()); }),
                   other = message_of<Error>([&] {
                       b = ask({complex(), volumes()});
                   });
        EXPECT_EQ(one == "accepted", other == "accepted") << one << '\n' << other;
        if (one != "accepted" || other != "accepted")
            return;
        EXPECT_LE((a - b).norm(), 1e-9 * a.norm());
        if (a.norm() > 0) {
            EXPECT_GT((a - factor * b).norm(), 1e-9 * a.norm()) << "times " << factor;
        }
    }
};

TEST_P(OwnCells, have_the_solutions_of_poisson_problems_that_meshes_have) {
    for (const Side side : sides)
        for (const auto condition : {BoundaryCondition::essential, BoundaryCondition::natural})
            expect_equal(1.1, [&](const Cells& cells) {
                return any_solution(cells, side, condition).form.values;
            });
}

TEST_P(OwnCells, have_the_flows_that_meshes_have) {
    expect_equal(-1, [&](const Cells& cells) {
        return any_solution(cells, Side::dual, BoundaryCondition::essential).flux.values;
    });
}

TEST_P(OwnCells, have_heat_waves_and_decompositions) {
    for (int k = 0; k <= complex().dimension(); ++k)
        for (const Side side : sides) {
            const int degree = side == Side::primal ? k : complex().dimension() - k;
            const Cochain form{side, degree, random_vector(complex().size(k), 3)};
            for (const auto condition : {BoundaryCondition::essential, BoundaryCondition::natural})
                expect_equal(1.1, [&](const Cells& cells) {
                    return heated({cells, side, degree, {condition}}, form, 0.1).values;
                });
            expect_equal(1.1, [&](const Cells& cells) {
                return hodge_decomposition({cells, side, degree}, form).copotential.values;
            });
        }
}

TEST_P(OwnCells, have_the_stable_steps_that_meshes_have) {
    for (int k = 0; k < complex().dimension(); ++k)
        expect_equal(1.1, [&](const Cells& cells) {
            return Vector::Constant(1, 2 / stable_step({cells, Side::primal, k})).eval();
        });
}

POLYDEC_OVER_MESHES(OwnCells);

TEST(OwnCellsOfAGrid, share_what_flows_through_a_facet_among_its_vertices) {
    for (const int n : {1, 2, 3}) {
        const auto mesh = circumcentric(kuhn(n, 3));
        const PoissonSolver own(functions({mesh.complex(), mesh.volumes()}, Side::primal,
                                          {BoundaryCondition::natural}));
        const Points centers = cell_centers(mesh, n - 1);
        Vector slopes = Vector::Zero(centers.rows()); // of x along the outward normal
        for (Index f = 0; f < slopes.size(); ++f)
            slopes[f] = centers(f, 0) == 0 ? -1 : centers(f, 0) == 1 ? 1 : 0;
        const Vector none = Vector::Zero(mesh.complex().size(0));
        const auto error = [&](double factor) {
            const Vector u = solved(own, none, {}, factor * slopes).form.values;
            const Vector x = mesh.points().col(0);
            return (u.array() - (x.array() - 0.5)).abs().maxCoeff();
        };
        EXPECT_LE(error(1), 1e-12) << "n = " << n;
        EXPECT_GT(error(2), 0.1) << "n = " << n;
    }
}

TEST(OwnCellsRefuse, volumes_of_other_cells) {
    const auto mesh = circumcentric(grid(2, 2)), other = circumcentric(grid(3, 2));
    EXPECT_THROW(Cells(mesh.complex(), other.volumes()), InvalidInput);
}

} // namespace polydec::test::in_own_cells
