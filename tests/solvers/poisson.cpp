// SPDX-License-Identifier: MIT
#include "solvers/poisson.h"

#include "base/errors.h"
#include "complex/components.h"
#include "meshes/generate.h"
#include "meshes/rearrange.h"
#include "tests/support/circumcentric.h"
#include "tests/support/hand_made.h"
#include "tests/support/read_golden.h"
#include "tests/support/refusal.h"
#include "tests/support/says.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace polydec::test::in_poisson {
namespace {

using Function = std::function<double(const Vector& point)>;

Vector values(const Function& function, const Points& sites) {
    Vector result(sites.rows());
    for (Index i = 0; i < result.size(); ++i)
        result[i] = function(sites.row(i).transpose());
    return result;
}

/// Root of the integral of the squared difference, every value weighted by its cell's volume.
double l2(const Discretization& mesh, Side side, const Vector& difference) {
    const Vector& volume =
        side == Side::primal ? mesh.volumes().dual(0) : mesh.volumes().primal(mesh.dimension());
    return std::sqrt(volume.dot(difference.cwiseAbs2()));
}

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

double franke_error(const Mesh& input, Side side) {
    const auto mesh = circumcentric(input);
    PoissonSolver solver(mesh, {.side = side});
    const auto [u, report, compatibility, warnings] = solver.solve(
        values(franke_laplacian, solver.sites()), values(franke, solver.boundary_sites()));
    EXPECT_LE(report.residual, 1e-10);
    return l2(mesh, side, u - values(franke, solver.sites()));
}

/// The errors, by an independent program, of grids with N = 8, 16, 32.
TEST(FrankesProblem, has_the_known_errors_on_grids) {
    const auto expect = [](Side side, const std::array<double, 3>& known) {
        Index N = 8;
        for (const double error : known) {
            EXPECT_NEAR(franke_error(grid(N, N), side), error, 0.05 * error) << N;
            N *= 2;
        }
    };
    expect(Side::dual, {0.0176, 0.00358, 8.73e-4});
    expect(Side::primal, {0.0182, 0.00428, 0.00105});
}

TEST(FrankesProblem, converges_with_order_2_on_grids_and_hexagons) {
    for (const Side side : {Side::primal, Side::dual})
        for (const auto& make :
             std::vector<std::function<Mesh(int)>>{[](int N) { return grid(N, N); }, hexagons}) {
            const double order =
                std::log2(franke_error(make(16), side) / franke_error(make(32), side));
            EXPECT_NEAR(order, 2.0, 0.15) << name(side);
        }
}

double linear(const Vector& p) {
    return 0.3 + Vector::LinSpaced(p.size(), 1.0, -2.0).dot(p);
}

double error_of_linear_solution(const Mesh& input, Side side) {
    const auto mesh = circumcentric(input);
    PoissonSolver solver(mesh, {.side = side});
    const Vector u =
        solver.solve(Vector::Zero(solver.sites().rows()), values(linear, solver.boundary_sites()))
            .values;
    return (u - values(linear, solver.sites())).cwiseAbs().maxCoeff();
}

TEST(LinearFunctions, are_solved_exactly_on_flat_meshes_primal) {
    for (const auto& mesh : {grid(7, 5), hexagons(5), well_centered(4), kuhn(1, 6), kuhn(3, 3),
                             bcc(2), fcc(2), kuhn(4, 2), perturbed(well_centered(4), 0.01, 3)})
        EXPECT_LE(error_of_linear_solution(mesh, Side::primal), 1e-11);
}

TEST(LinearFunctions, are_solved_exactly_on_flat_meshes_dual) {
    for (const auto& mesh : {grid(7, 5), hexagons(5), well_centered(4), kuhn(1, 6), kuhn(3, 3),
                             bcc(2), fcc(2), kuhn(4, 2), perturbed(well_centered(4), 0.01, 3)})
        EXPECT_LE(error_of_linear_solution(mesh, Side::dual), 1e-11);
}

/// There the circumcenters of some cells lie on the boundary.
TEST(LinearFunctions, are_exact_where_boundary_facets_have_no_dual) {
    for (const char* name : {"fcc1.nsc", "hex4.nsc"}) {
        const Mesh mesh = read_golden(name);
        EXPECT_GT(circumcentric(mesh).degenerate().boundary, 0) << name;
        EXPECT_LE(error_of_linear_solution(mesh, Side::dual), 1e-11) << name;
    }
}

/// Negative duals make the system indefinite and leave it right.
TEST(LinearFunctions, are_exact_on_obtuse_meshes) {
    for (const auto& mesh : {obtuse_planar(), obtuse_solid()})
        for (const Side side : {Side::primal, Side::dual})
            EXPECT_LE(error_of_linear_solution(mesh, side), 1e-9) << name(side);
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
        for (const Side side : {Side::primal, Side::dual}) {
            const auto mesh = circumcentric(input);
            PoissonSolver solver(mesh, {.side = side, .boundary = {BoundaryCondition::natural}});
            const Vector f = values(wave, solver.sites());
            const Vector none = Vector::Zero(solver.boundary_sites().rows());
            const auto [u, report, compatibility, warnings] = solver.solve(f, none);
            EXPECT_GT(u.norm(), 1e-3);
            ASSERT_EQ(means(mesh, side, u).size(), 2);
            EXPECT_LE(means(mesh, side, u).cwiseAbs().maxCoeff(), 1e-12);
            EXPECT_EQ(compatibility.free_components, 2);
            EXPECT_GT(compatibility.worst, 1e-3) << "f has means that are not zero";

            // the means of f are what was removed, so without them nothing changes
            const Vector rest = f - means(mesh, side, f)(components_of_sites(mesh, side));
            const auto again = solver.solve(rest, none);
            EXPECT_LE((again.values - u).norm(), 1e-10 * u.norm());
            EXPECT_LE(again.compatibility.worst, 1e-12);
        }
}

TEST(NaturalProblem, converges_to_a_solution_known) {
    const Function cosines = [](const Vector& p) {
        return std::cos(M_PI * p[0]) * std::cos(2 * M_PI * p[1]);
    };
    const auto error = [&](int N, Side side) {
        const auto mesh = circumcentric(grid(N, N));
        PoissonSolver solver(mesh, {.side = side, .boundary = {BoundaryCondition::natural}});
        const Vector u = solver
                             .solve(5 * M_PI * M_PI * values(cosines, solver.sites()),
                                    Vector::Zero(solver.boundary_sites().rows()))
                             .values;
        return l2(mesh, side, u - values(cosines, solver.sites()));
    };
    for (const Side side : {Side::primal, Side::dual})
        EXPECT_NEAR(std::log2(error(16, side) / error(32, side)), 2.0, 0.05) << name(side);
}

TEST(ClosedSurface, has_no_use_for_boundary_data) {
    const auto mesh = circumcentric(torus(16, 8));
    for (const Side side : {Side::primal, Side::dual}) {
        PoissonSolver fixed(mesh, {.side = side});
        PoissonSolver natural(mesh, {.side = side, .boundary = {BoundaryCondition::natural}});
        const Vector f = values(wave, fixed.sites());
        const auto [u, report, compatibility, warnings] =
            fixed.solve(f, Vector::Ones(fixed.boundary_sites().rows()));
        EXPECT_TRUE(u.isApprox(
            natural.solve(f, Vector::Zero(natural.boundary_sites().rows())).values, 1e-12));
        EXPECT_LE(means(mesh, side, u).cwiseAbs().maxCoeff(), 1e-12);
        EXPECT_EQ(compatibility.free_components, 1);
    }
}

TEST(Solutions, do_not_depend_on_the_unit_of_length) {
    for (const double scale : {1e-8, 1e8})
        for (const Side side : {Side::primal, Side::dual}) {
            const auto solve = [&](double length) {
                const auto mesh =
                    circumcentric(transformed(hexagons(6), DenseMatrix::Identity(2, 2), length));
                PoissonSolver solver(mesh, {.side = side});
                return solver
                    .solve(values(franke_laplacian, solver.sites() / length) / (length * length),
                           values(franke, solver.boundary_sites() / length))
                    .values;
            };
            EXPECT_TRUE(solve(scale).isApprox(solve(1), 1e-10)) << name(side) << ' ' << scale;
        }
}

std::string dual_refusal(const Mesh& mesh) {
    return refusal([&] { PoissonSolver(circumcentric(mesh), {.side = Side::dual}); });
}

TEST(DualProblemRefuses, what_has_not_two_sides) {
    EXPECT_TRUE(says(dual_refusal(moebius(12, 2)),
                     {"non-orientable", "dual 0-forms", "facet 0", "vertices 0, 1"}));
    EXPECT_TRUE(says(dual_refusal(read_golden("branching.off")),
                     {"3 cells", "facet 0", "vertices 0, 1", "flux"}));
}

TEST(DualProblemRefuses, interior_facets_without_dual) {
    EXPECT_TRUE(says(refusal([] {
                         const auto mesh =
                             circumcentric(grid(2, 2), {.criterion = MergeCriterion::none});
                         PoissonSolver(mesh, {.side = Side::dual});
                     }),
                     {"dual", "facet 2", "vertices 0, 4", "length"}));
}

TEST(PrimalProblem, needs_no_two_sides) {
    for (const auto& input : {moebius(12, 2), read_golden("branching.off")}) {
        const auto mesh = circumcentric(input);
        PoissonSolver solver(mesh);
        const Vector ones = Vector::Ones(solver.boundary_sites().rows());
        const Vector u = solver.solve(Vector::Zero(solver.sites().rows()), ones).values;
        EXPECT_LE((u.array() - 1).abs().maxCoeff(), 1e-12);
    }
}

TEST(PoissonSolverRefuses, data_that_are_no_numbers_or_too_few) {
    const auto mesh = circumcentric(grid(2, 2));
    PoissonSolver solver(mesh);
    const Vector zeros = Vector::Zero(9);
    Vector bad = zeros;
    bad[4] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(says(refusal([&] { solver.solve(bad, zeros); }), {"right-hand side", "4", "nan"}));
    bad[4] = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(says(refusal([&] { solver.solve(zeros, bad); }), {"boundary data", "4", "inf"}));
    EXPECT_TRUE(says(refusal([&] { solver.solve(Vector::Zero(8), zeros); }),
                     {"right-hand side", "8 values", "9 places"}));
    EXPECT_TRUE(says(refusal([&] { solver.solve(zeros, Vector::Zero(10)); }),
                     {"boundary data", "10 values", "9 places"}));
}

TEST(PoissonSolverRefuses, data_that_overflow_with_the_volumes) {
    const auto mesh = circumcentric(grid(2, 2));
    for (const Side side : {Side::primal, Side::dual}) {
        PoissonSolver solver(mesh, {.side = side});
        const Vector f = Vector::Zero(solver.sites().rows());
        const Vector values = Vector::Constant(solver.boundary_sites().rows(), -1.5e308);
        EXPECT_TRUE(
            says(refusal([&] { solver.solve(f, values); }),
                 {"right-hand side", side == Side::primal ? "0-cell 4" : "2-cell 0", "-inf"}));
        EXPECT_TRUE(solver.solve(f, values / 16).values.allFinite());
    }
}

} // namespace
} // namespace polydec::test::in_poisson
