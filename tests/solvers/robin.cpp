// SPDX-License-Identifier: MIT
#include "dec/choose_stars.h"
#include "dec/fields/cell_centers.h"
#include "meshes/generate.h"
#include "solvers/darcy.h"
#include "solvers/heat.h"
#include "solvers/poisson.h"
#include "solvers/spectra/spectrum.h"
#include "tests/support/families.h"
#include "tests/support/matrices.h"
#include "tests/support/refusal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace polydec::test {
namespace {

constexpr Side sides[] = {Side::primal, Side::dual};
constexpr StarKind kinds[] = {StarKind::circumcentric, StarKind::galerkin};

BoundaryConditions robin(double coefficient) {
    return {BoundaryCondition::robin, {}, {coefficient}};
}

Discretization with(const Mesh& input, StarKind kind) {
    const auto mesh = discretize(input);
    return kind == StarKind::circumcentric ? mesh : mesh.with_stars(choose_stars(mesh, kind));
}

double wave(const Vector& p) {
    return std::sin(2 * p[0] + 0.3) * std::cos(p[1]);
}

/// Its outward derivative at the middle of a facet of the unit square.
double slope(const Vector& p) {
    const double x = 2 * std::cos(2 * p[0] + 0.3) * std::cos(p[1]);
    const double y = -std::sin(2 * p[0] + 0.3) * std::sin(p[1]);
    return p[0] < 1e-9 ? -x : p[0] > 1 - 1e-9 ? x : p[1] < 1e-9 ? -y : y;
}

/// L2 error of the wave where slope + coefficient u is given; solved with another coefficient.
double error(const Mesh& input, Side side, StarKind kind, double coefficient, double solved_with) {
    const auto mesh = with(input, kind);
    const PoissonSolver solver(mesh, {.side = side, .boundary = robin(solved_with)});
    const auto at = [](const Points& sites, auto function) {
        Vector result(sites.rows());
        for (Index i = 0; i < result.size(); ++i)
            result[i] = function(sites.row(i).transpose());
        return result;
    };
    const Vector exact = at(solver.sites(), wave);
    const Vector data =
        at(solver.flux_sites(), [&](const Vector& p) { return slope(p) + coefficient * wave(p); });
    const Vector u =
        solver.solve(5 * exact, Vector::Zero(solver.boundary_sites().rows()), data).values;
    const Vector weights = side == Side::primal ? mesh.volumes().dual(0) : mesh.volumes().primal(2);
    return std::sqrt(weights.cwiseAbs().dot((u - exact).cwiseAbs2()));
}

TEST(Robin, converges_with_order_2_on_both_sides) {
    const std::function<Mesh(int)> families[] = {[](int m) { return grid(m, m); }, hexagons,
                                                 well_centered};
    for (const auto& make : families)
        for (const Side side : sides)
            for (const StarKind kind : kinds)
                for (const double coefficient : {0.1, 1.0, 50.0}) {
                    const auto order = [&](double solved_with) {
                        return std::log2(error(make(8), side, kind, coefficient, solved_with) /
                                         error(make(16), side, kind, coefficient, solved_with));
                    };
                    EXPECT_GE(order(coefficient), 1.8) << name(side) << ' ' << coefficient;
                    EXPECT_LT(order(2 * coefficient), 1.0) << name(side) << ' ' << coefficient;
                }
}

/// -u'' = 1 on [0, 1] with u' = alpha u at both ends: u = x (1 - x) / 2 + 1 / (2 alpha), which is
/// the value at vertices exactly; in every dimension with no flow through the sides.
TEST(Robin, of_a_slab_is_exact) {
    constexpr double alpha = 3;
    for (const Mesh& input : {kuhn(1, 7), grid(5, 5), kuhn(3, 3)}) {
        const auto mesh = discretize(input);
        const int n = mesh.dimension();
        BoundaryConditions ends{BoundaryCondition::natural};
        const Points facets = cell_centers(mesh, n - 1);
        for (Index f = 0; f < facets.rows(); ++f)
            ends.facets.push_back(std::abs(facets(f, 0) - 0.5) > 0.5 - 1e-9
                                      ? BoundaryCondition::robin
                                      : BoundaryCondition::natural);
        ends.coefficients.assign(static_cast<std::size_t>(facets.rows()), alpha);
        for (const Side side : sides) {
            const PoissonSolver solver(mesh, {.side = side, .boundary = ends});
            const auto solution = solver.solve(Vector::Ones(solver.sites().rows()),
                                               Vector::Zero(solver.boundary_sites().rows()));
            const auto x = solver.sites().col(0).array();
            // a cell's balance lets dual values be off by an eighth of the square of its length
            const double h = 1 / std::round(std::pow(mesh.complex().size(n), 1.0 / n));
            const double offset = side == Side::primal ? 0 : h * h / 8;
            const Vector exact = x * (1 - x) / 2 + 1 / (2 * alpha) + offset;
            EXPECT_LE(relative_difference(solution.values, exact), 1e-11) << n << name(side);
            EXPECT_EQ(solution.compatibility.free_components, 0);
        }
    }
}

TEST(Robin, of_an_infinite_coefficient_is_Dirichlets_and_of_none_Neumanns) {
    for (const char* name_of : {"grid4", "wellcentred4", "kuhn3", "ring6", "hexagons5"})
        for (const Side side : sides)
            for (const StarKind kind : kinds) {
                const auto mesh = with(mesh_named(name_of), kind);
                const auto solution = [&](const BoundaryConditions& conditions, double data) {
                    const PoissonSolver solver(mesh, {.side = side, .boundary = conditions});
                    const Vector f = random_vector(solver.sites().rows(), 1);
                    return solver
                        .solve(f, Vector::Constant(solver.boundary_sites().rows(), 0.7),
                               Vector::Constant(solver.flux_sites().rows(), data))
                        .values;
                };
                const Vector dirichlet = solution({BoundaryCondition::essential}, 0);
                EXPECT_LE(relative_difference(solution(robin(1e9), 0.7e9), dirichlet), 1e-6)
                    << name_of << name(side);
                EXPECT_GT(relative_difference(solution(robin(1), 0.7), dirichlet), 1e-3);
            }
}

TEST(Robin, is_refused_where_it_and_a_negative_half_dual_leave_no_resistance) {
    const auto mesh = discretize(mesh_named("bcc2"));
    EXPECT_EQ(refusal([&] { PoissonSolver(mesh, {.side = Side::dual, .boundary = robin(16)}); }),
              "the dual of facet 0 (vertices 0, 1, 3, 4), of length -0.125, and 1 over the "
              "coefficient of Robin's condition there add up to -0.0625: expected a positive sum; "
              "take a smaller coefficient or primal forms");
    EXPECT_EQ(refusal([&] { PoissonSolver(mesh, {.side = Side::dual, .boundary = robin(4)}); }),
              "accepted");
}

TEST(Robin, is_refused_by_name_where_it_is_not_known) {
    const auto mesh = discretize(grid(2, 2));
    const std::string expected = "facet 0 has Robin's condition, which this problem cannot have: "
                                 "PoissonSolver and HodgeLaplaceSolver can";
    EXPECT_EQ(refusal([&] { spectrum(mesh, robin(1), {.count = 1}); }), expected);
    EXPECT_EQ(refusal([&] { HeatSolver(mesh, robin(1), Side::primal, 0, {.time_step = 1}); }),
              expected);
    EXPECT_EQ(refusal([&] { DarcySolver(mesh, {.boundary = robin(1)}); }),
              "facet 0 has Robin's condition, which Darcy's problem cannot have: PoissonSolver and "
              "HodgeLaplaceSolver can");
    EXPECT_EQ(refusal([&] { PoissonSolver(mesh, {.boundary = robin(-1)}); }),
              "the coefficient of Robin's condition at 1-cell 0 is -1: expected a positive number; "
              "0 is the natural condition");
    EXPECT_EQ(refusal([&] { PoissonSolver(mesh, {.boundary = {BoundaryCondition::robin}}); }),
              "0 coefficients of Robin's condition are given: expected one for all facets, or one "
              "for each of the 12 1-cells");
}

TEST(Tags, of_facets_make_conditions) {
    const std::vector<Index> tags{0, 3, 3, 7};
    const auto conditions = essential_on(tags, {3});
    EXPECT_EQ(conditions.at(0), BoundaryCondition::natural);
    EXPECT_EQ(conditions.at(1), BoundaryCondition::essential);
    EXPECT_EQ(conditions.at(3), BoundaryCondition::natural);
    EXPECT_EQ(refusal([&] { essential_on(tags, {4}); }),
              "no facet has the tag 4: the tags are 0, 3, 7");
    EXPECT_EQ(refusal([&] { essential_on({}, {4}); }),
              "no facet has the tag 4: the mesh has no facets with tags");
}

} // namespace
} // namespace polydec::test
