// SPDX-License-Identifier: MIT
#include "solvers/hodge_laplace.h"

#include "complex/relative.h"
#include "dec/fields/cell_centers.h"
#include "dec/material_stars.h"
#include "dec/operators.h"
#include "meshes/generate.h"
#include "meshes/rearrange.h"
#include "tests/solvers/wave_problems.h"
#include "tests/support/circumcentric.h"
#include "tests/support/families.h"
#include "tests/support/matrices.h"
#include "tests/support/refusal.h"
#include "tests/support/says.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace polydec::test::in_hodge_laplace {
namespace {

constexpr Side sides[] = {Side::primal, Side::dual};

/// Norm of the error over that of the solution; the source is `factor` times that of the solution.
double error(const Discretization& mesh, Side side, int degree, Where where, double factor = 1) {
    const WaveForm wave(mesh.dimension(), degree, 1.5);
    const Cochain exact = exact_form(mesh, side, wave);
    HodgeLaplaceSolver solver(mesh, {side, degree, conditions_of(mesh, where)});
    // orthonormal harmonic forms have the products with a form as coefficients
    DenseMatrix harmonic = solver.harmonic_forms();
    Vector coefficients(harmonic.cols());
    for (Index i = 0; i < coefficients.size(); ++i)
        coefficients[i] = inner_product(mesh, exact, {side, degree, harmonic.col(i)});
    const auto solution = solver.solve(factor * wave.eigenvalue() * exact,
                                       data_of(mesh, side, wave, where), coefficients);
    return size_of(mesh, solution.form - exact) / size_of(mesh, exact);
}

struct Family {
    const char* name;
    std::function<Mesh(int)> make;
    int coarse, fine;
    StarKind stars;
    double primal_order, dual_order; ///< at least, of every degree and condition
    int conditions = 4;              ///< how many of these converge in every degree
};

void PrintTo(const Family& family, std::ostream* out) {
    *out << family.name;
}

double order(const Family& family, Side side, int degree, Where where) {
    const auto e = [&](int cells) {
        const auto mesh = circumcentric(family.make(cells));
        return error(family.stars == StarKind::circumcentric ? mesh : mesh.with_stars(family.stars),
                     side, degree, where);
    };
    return std::log(e(family.coarse) / e(family.fine)) /
           std::log(static_cast<double>(family.fine) / family.coarse);
}

class FormSources : public testing::TestWithParam<Family> {
protected:
    static int dimension() { return GetParam().make(GetParam().coarse).dimension(); }
};

TEST_P(FormSources, of_every_degree_side_and_condition_converge) {
    const auto& family = GetParam();
    int solved = 0;
    for (const Side side : sides)
        for (int k = 0; k <= dimension(); ++k)
            for (int i = 0; i < family.conditions; ++i) {
                const auto least = side == Side::primal ? family.primal_order : family.dual_order;
                double found = 0;
                const auto refused =
                    refusal([&] { found = order(family, side, k, everywhere[i]); });
                if (refused != "accepted") { // duals that are not positive, of other stars
                    EXPECT_EQ(family.stars, StarKind::circumcentric);
                    EXPECT_TRUE(says(refused, {"mass", "not positive"}));
                    continue;
                }
                ++solved;
                EXPECT_GE(found, least) << name(side) << ' ' << k << ", condition " << i;
            }
    EXPECT_GE(solved, std::min(3, family.conditions) * (dimension() + 1));
}

TEST_P(FormSources, do_not_converge_to_another_solution) {
    const auto& [name_of, make, coarse, fine, stars, primal_order, dual_order, conditions] =
        GetParam();
    const auto mesh = circumcentric(make(coarse));
    for (const Side side : sides) { // both on vertices, whose duals are positive everywhere
        const int degree = side == Side::primal ? 0 : dimension();
        EXPECT_GT(error(mesh, side, degree, Where::natural, 1.5), 0.05) << name(side);
    }
}

/// Inner points moved at random; the boundary stays that of the unit cube.
Mesh shaken(Mesh mesh, double amplitude) {
    const Mesh moved = perturbed(mesh, amplitude, 1);
    for (Index v = 0; v < mesh.points.rows(); ++v)
        if ((mesh.points.row(v).array() > 1e-9).all() &&
            (mesh.points.row(v).array() < 1 - 1e-9).all())
            mesh.points.row(v) = moved.points.row(v);
    return mesh;
}

Mesh shaken_triangles(int cells) {
    return shaken(well_centered(cells), 0.03 / cells);
}

Mesh shaken_tetrahedra(int cells) {
    return shaken(bcc(cells), 0.03 / cells);
}

constexpr auto by_duals = StarKind::circumcentric, galerkin = StarKind::galerkin;

// Order 2 where cells are alike; 3/2 of values on half duals at a boundary, where they are known at
// the end and not in the middle, and on triangles that are not alike; 1 of Whitney forms between
// degrees 0 and n; 1/2 of dual n-forms where hybrid stars change from one kind to the other.
INSTANTIATE_TEST_SUITE_P(
    Flat, FormSources,
    testing::Values(Family{"grid", [](int m) { return grid(m, m); }, 8, 16, by_duals, 1.85, 1.45},
                    Family{"triangles", well_centered, 8, 16, by_duals, 1.4, 1.0},
                    Family{"shaken", shaken_triangles, 8, 16, by_duals, 1.4, 1.0},
                    Family{"hexagons", hexagons, 8, 16, by_duals, 1.5, 1.5},
                    Family{"shaken_galerkin", shaken_triangles, 8, 16, galerkin, 1.3, 1.0},
                    Family{"hexagons_hybrid", hexagons, 8, 16, StarKind::hybrid, 1.0, 0.45},
                    Family{"hexagons_galerkin", hexagons, 8, 16, galerkin, 1.0, 0.8},
                    Family{"cubes", [](int m) { return kuhn(3, m); }, 3, 5, by_duals, 1.6, 1.4},
                    Family{"bcc", [](int m) { return bcc(m); }, 2, 4, by_duals, 1.35, 1.35},
                    Family{"fcc", [](int m) { return fcc(m); }, 2, 3, by_duals, 1.0, 1.0},
                    Family{"bcc_galerkin", shaken_tetrahedra, 2, 4, galerkin, 1.3, 1.0, 1}),
    [](const auto& instance) { return std::string(instance.param.name); });

/// A torus, an annulus of merged quads, and a solid torus: Betti numbers 1 2 1, 1 1, 1 1.
std::vector<Mesh> with_harmonic_forms() {
    return {torus(12, 8), mesh_named("ring6"), mesh_named("solid_torus3")};
}

TEST(HarmonicPart, is_removed_from_the_source_and_given_to_the_solution) {
    int seen = 0;
    for (const Mesh& input : with_harmonic_forms()) {
        auto mesh = circumcentric(input);
        mesh = mesh.with_stars(StarKind::automatic);
        const int n = mesh.dimension();
        for (const Side side : sides)
            for (int k = 0; k <= n; ++k)
                for (const auto condition :
                     {BoundaryCondition::essential, BoundaryCondition::natural}) {
                    HodgeLaplaceSolver solver(mesh, {side, k, {condition}});
                    const DenseMatrix H = solver.harmonic_forms();
                    if (H.cols() == 0)
                        continue;
                    ++seen;
                    const Cochain h{side, k, H * Vector::LinSpaced(H.cols(), 1, 2)};
                    const auto none = solver.solve(h);
                    EXPECT_LE(norm(mesh, none.removed - h), 1e-9 * norm(mesh, h));
                    EXPECT_LE(norm(mesh, none.form), 1e-7 * norm(mesh, h));
                    const auto given = solver.solve(0.0 * h, {}, Vector::LinSpaced(H.cols(), 1, 2));
                    EXPECT_LE(norm(mesh, given.form - h), 1e-9 * norm(mesh, h));
                    EXPECT_GT(norm(mesh, given.form - 2.0 * h), 0.1 * norm(mesh, h));
                }
    }
    EXPECT_GE(seen, 12);
}

TEST(CurlCurl, removes_what_is_no_curl_and_keeps_the_gauge) {
    auto mesh = circumcentric(kuhn(3, 4));
    const Vector permeability = Vector::LinSpaced(mesh.complex().size(3), 1, 3);
    for (const bool material : {false, true}) {
        if (material)
            mesh = mesh.with_stars(mesh.stars().with(
                2, material_star(mesh, 2, CellData::on_cells(permeability.cwiseInverse()))));
        HodgeLaplaceSolver solver(mesh, {.degree = 1});
        const auto relative = relative_to_boundary(mesh.complex());
        const auto inside = [&](int k, unsigned seed) {
            return relative.extend(k, random_vector(relative.complex.size(k), seed));
        };
        const Cochain curl =
            codifferential(mesh, {Side::primal, 2, random_vector(mesh.complex().size(2), 1)});
        const Cochain gradient = d(mesh, Cochain{Side::primal, 0, inside(0, 2)});
        const auto solution = solve_curl_curl(solver, mesh.complex(), curl + gradient);
        EXPECT_LE(norm(mesh, solution.removed - gradient), 1e-8 * norm(mesh, gradient));
        const Vector left = relative.restrict(
            1, codifferential(mesh, d(mesh, solution.potential)).values - curl.values);
        EXPECT_LE(left.norm(), 1e-8 * curl.values.norm());
        const Vector gauge = relative.restrict(0, codifferential(mesh, solution.potential).values);
        EXPECT_LE(gauge.norm(), 1e-8 * curl.values.norm());
        // with Delta u = j alone the gauge is lost
        const auto whole = solver.solve(curl + gradient);
        EXPECT_GT(relative.restrict(0, codifferential(mesh, whole.form).values).norm(),
                  1e-3 * curl.values.norm());
    }
}

TEST(FormSourceErrors, name_what_does_not_fit) {
    const auto mesh = circumcentric(grid(2, 2));
    const HodgeLaplaceSolver solver(mesh, {.degree = 1});
    EXPECT_TRUE(says(refusal([&] {
                         solver.solve({Side::primal, 0, Vector::Zero(9)});
                     }),
                     {"primal 0-form", "primal 1-forms"}));
    EXPECT_TRUE(
        says(refusal([&] {
                 solver.solve({Side::primal, 1, Vector::Zero(12)}, {.flow = Vector::Zero(3)});
             }),
             {"3 boundary values", "star", "9"}));
    EXPECT_TRUE(says(refusal([&] { HodgeLaplaceSolver(mesh, {.degree = 3}); }),
                     {"primal forms", "degree 3", "dimension 2", "0", "2"}));
}

TEST(BoundaryDeRham, completes_the_derivative_of_dual_forms) {
    for (const Mesh& input : {hexagons(5), well_centered(3), kuhn(3, 1), bcc(1)}) {
        const auto mesh = circumcentric(input);
        const int n = mesh.dimension();
        for (int j = 0; j < n; ++j) {
            const WaveForm wave(n, j, 0.7);
            const Vector inside =
                dual_derivative(mesh, j) * dual_de_rham(mesh, j, wave.form(), 9).values;
            const Vector whole = dual_de_rham(mesh, j + 1, wave.derivative(), 9).values;
            const Vector data = boundary_de_rham(mesh, j, wave.form(), 9);
            const SparseMatrix B = dual_boundary_derivative(mesh.complex(), j);
            EXPECT_LE(relative_difference(Vector(inside + B * data), whole), 1e-7) << n << j;
            EXPECT_GT(relative_difference(Vector(inside - B * data), whole), 1e-2) << n << j;
        }
    }
}

} // namespace
} // namespace polydec::test::in_hodge_laplace
