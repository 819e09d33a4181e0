// SPDX-License-Identifier: MIT
#include "dec/fields/cell_centers.h"
#include "meshes/generate.h"
#include "solvers/darcy.h"
#include "solvers/heat.h"
#include "solvers/hodge.h"
#include "solvers/poisson.h"
#include "solvers/waves.h"
#include "tests/dec/discretized.h"
#include "tests/support/circumcentric.h"
#include "tests/support/matrices.h"
#include "tests/support/over_meshes.h"
#include "tests/support/refusal.h"
#include "tests/support/says.h"

#include <gtest/gtest.h>

#include <cmath>

namespace polydec::test::in_own_cells {
namespace {

/// Solvers on complex and volumes alone, against those of a mesh that has these.
class OwnCells : public OverMeshes {
protected:
    const Discretization& whole() const { return discretized(GetParam()); }
    const CellComplex& complex() const { return whole().complex(); }
    const CellVolumes& volumes() const { return whole().volumes(); }
};

/// Both results, or that both are refused.
template <class First, class Second>
void expect_equal(First first, Second second, double factor) {
    Vector a, b;
    const auto one = message_of<Error>([&] { a = first(); }),
               other = message_of<Error>([&] { b = second(); });
    EXPECT_EQ(one == "accepted", other == "accepted") << one << '\n' << other;
    if (one != "accepted" || other != "accepted")
        return;
    EXPECT_LE((a - b).norm(), 1e-9 * a.norm());
    if (a.norm() > 0) {
        EXPECT_GT((a - factor * b).norm(), 1e-9 * a.norm()) << "times " << factor;
    }
}

TEST_P(OwnCells, have_the_solutions_of_poisson_problems_that_meshes_have) {
    for (const Side side : {Side::primal, Side::dual})
        for (const auto condition : {BoundaryCondition::essential, BoundaryCondition::natural}) {
            const PoissonOptions options{.side = side, .boundary = {condition}};
            const auto solved = [&](const PoissonSolver& solver) {
                const Vector f = random_vector(solver.sites().rows(), 1);
                const Vector g = random_vector(solver.boundary_sites().rows(), 2);
                return solver.solve(f, g).values;
            };
            expect_equal([&] { return solved(PoissonSolver(whole(), options)); },
                         [&] {
                             return solved(PoissonSolver({complex(), volumes()}, options));
                         },
                         1.1);
        }
}

TEST_P(OwnCells, have_the_flows_that_meshes_have) {
    const auto solved = [&](const DarcySolver& solver) {
        const Vector f = random_vector(solver.sites().rows(), 1);
        const Vector g = random_vector(solver.facet_sites().rows(), 2);
        return solver.solve(f, g, g).flux.values;
    };
    expect_equal([&] { return solved(DarcySolver(whole())); },
                 [&] {
                     return solved(DarcySolver({complex(), volumes()}));
                 },
                 -1);
}

TEST_P(OwnCells, have_heat_waves_and_decompositions) {
    for (int k = 0; k <= complex().dimension(); ++k)
        for (const Side side : {Side::primal, Side::dual}) {
            const int degree = side == Side::primal ? k : complex().dimension() - k;
            const Cochain form{side, degree, random_vector(complex().size(k), 3)};
            const HeatOptions options{.time_step = 0.1};
            for (const auto condition : {BoundaryCondition::essential, BoundaryCondition::natural})
                expect_equal(
                    [&] {
                        return HeatSolver({whole(), side, degree, {condition}}, options)
                            .step(form)
                            .values;
                    },
                    [&] {
                        return HeatSolver({{complex(), volumes()}, side, degree, {condition}},
                                          options)
                            .step(form)
                            .values;
                    },
                    1.1);
            expect_equal(
                [&] {
                    return hodge_decomposition({whole(), form.side, form.degree}, form)
                        .copotential.values;
                },
                [&] {
                    return hodge_decomposition({{complex(), volumes()}, form.side, form.degree},
                                               form)
                        .copotential.values;
                },
                1.1);
        }
}

TEST_P(OwnCells, have_the_stable_steps_that_meshes_have) {
    const auto frequency = [](double step) { return Vector(Vector::Constant(1, 2 / step)); };
    for (int k = 0; k < complex().dimension(); ++k)
        expect_equal(
            [&] {
                return frequency(stable_step({whole(), Side::primal, k}));
            },
            [&] {
                return frequency(stable_step({{complex(), volumes()}, Side::primal, k}));
            },
            1.1);
}

POLYDEC_OVER_MESHES(OwnCells);

TEST(OwnCellsOfAGrid, share_what_flows_through_a_facet_among_its_vertices) {
    for (const int n : {1, 2, 3}) {
        const auto mesh = circumcentric(kuhn(n, 3));
        const PoissonOptions options{.boundary = {BoundaryCondition::natural}};
        const PoissonSolver own({mesh.complex(), mesh.volumes()}, options);
        const Points centers = cell_centers(mesh, n - 1);
        Vector slopes = Vector::Zero(centers.rows()); // of x along the outward normal
        for (Index f = 0; f < slopes.size(); ++f)
            slopes[f] = centers(f, 0) == 0 ? -1 : centers(f, 0) == 1 ? 1 : 0;
        const Vector none = Vector::Zero(mesh.complex().size(0));
        const auto error = [&](double factor) {
            const Vector u = own.solve(none, none, factor * slopes).values;
            const Vector x = mesh.points().col(0);
            return (u.array() - (x.array() - 0.5)).abs().maxCoeff();
        };
        EXPECT_LE(error(1), 1e-12) << "n = " << n;
        EXPECT_GT(error(2), 0.1) << "n = " << n;
        EXPECT_EQ(own.sites().cols(), 0);
    }
}

TEST(OwnCellsRefuse, conductivities_and_volumes_of_other_cells) {
    const auto mesh = circumcentric(grid(2, 2)), other = circumcentric(grid(3, 2));
    EXPECT_TRUE(
        says(refusal([&] {
                 PoissonSolver({mesh.complex(), mesh.volumes()}, {.conductivity = Vector::Ones(4)});
             }),
             {"conductivities", "cells of one's own"}));
    EXPECT_NE(refusal([&] { PoissonSolver({mesh.complex(), other.volumes()}); }), "accepted");
}

} // namespace
} // namespace polydec::test::in_own_cells
