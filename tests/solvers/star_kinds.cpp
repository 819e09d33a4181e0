// SPDX-License-Identifier: MIT
//
// What solvers make of stars that are no diagonal.
#include "base/decompositions.h"
#include "dec/fields/cell_centers.h"
#include "dec/forms/derivative.h"
#include "dec/forms/laplacian.h"
#include "dec/material_stars.h"
#include "meshes/generate.h"
#include "solvers/heat.h"
#include "solvers/hodge.h"
#include "solvers/poisson.h"
#include "solvers/spectrum.h"
#include "tests/support/circumcentric.h"
#include "tests/support/families.h"
#include "tests/support/glued.h"
#include "tests/support/matrices.h"
#include "tests/support/refusal.h"
#include "tests/support/says.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

namespace polydec::test::in_star_kinds {
namespace {

const HeatOptions quick{.time_step = 0.1};

/// Heat shrinks an eigenform by 1 / (1 + dt lambda) with each step.
void expect_eigenforms_to_shrink(const CellComplex& complex, const HodgeStars& stars, int k) {
    const Operator applied = symmetric_laplacian(complex, stars, k);
    DenseMatrix A(complex.size(k), complex.size(k)); // which may be dense
    for (Index i = 0; i < A.cols(); ++i)
        A.col(i) = applied * Vector::Unit(A.cols(), i);
    const DenseMatrix M(stars[k].matrix());
    const Eigen::GeneralizedSelfAdjointEigenSolver<DenseMatrix> modes(A, M);
    const HeatSolver primal(complex, stars, Side::primal, k, quick);
    const int j = complex.dimension() - k;
    const HeatSolver dual(complex, stars, Side::dual, j, quick);
    for (const Index i : {Index{0}, static_cast<Index>(A.rows() / 2)}) {
        const Vector form = modes.eigenvectors().col(i);
        const double factor = 1 / (1 + quick.time_step * modes.eigenvalues()[i]);
        EXPECT_LE(relative_difference(primal.step({Side::primal, k, form}).values, factor * form),
                  1e-8)
            << "k = " << k;
        const Vector flux = stars[k] * form;
        EXPECT_LE(relative_difference(dual.step({Side::dual, j, flux}).values, factor * flux), 1e-8)
            << "k = " << k;
        EXPECT_GT(relative_difference(primal.step({Side::primal, k, form}).values,
                                      factor * factor * form + form),
                  1e-3);
        const HeatSolver second(complex, stars, Side::primal, k,
                                {.time_step = 0.1, .scheme = HeatScheme::crank_nicolson});
        const double half = quick.time_step * modes.eigenvalues()[i] / 2;
        EXPECT_LE(relative_difference(second.step({Side::primal, k, form}).values,
                                      (1 - half) / (1 + half) * form),
                  1e-8);
    }
}

TEST(HeatByStars, shrinks_eigenforms_on_obtuse_surfaces) {
    const auto mesh = circumcentric(shaken(grid(5, 5), 0.42, 3));
    ASSERT_TRUE(says(refusal([&] { HeatSolver(mesh, Side::primal, 1, quick); }), {"not positive"}));
    const auto stars = mesh.with_stars(StarKind::automatic).stars();
    ASSERT_FALSE(stars[1].is_diagonal());
    for (const int k : {0, 1})
        expect_eigenforms_to_shrink(mesh.complex(), stars, k);
}

TEST(HeatByStars, shrinks_eigenforms_on_obtuse_tets) {
    const auto mesh = circumcentric(shaken(kuhn(3, 2), 0.3, 3));
    const auto chosen = mesh.with_stars(StarKind::automatic).chosen_stars();
    ASSERT_EQ(chosen.kind, StarKind::galerkin);
    for (const int k : {0, 1})
        expect_eigenforms_to_shrink(mesh.complex(), chosen.stars, k);
}

TEST(HeatByStars, keeps_conditions_on_the_boundary) {
    const auto mesh = circumcentric(shaken(grid(5, 5), 0.42, 3));
    const auto stars = mesh.with_stars(StarKind::automatic).stars();
    BoundaryConditions fixed;
    fixed.everywhere = BoundaryCondition::essential;
    const auto space = conditioned_complex(mesh.complex(), stars, Side::primal, 1, fixed);
    ASSERT_LT(space.relative.complex.size(1), mesh.complex().size(1));
    ASSERT_FALSE(space.stars[1].is_diagonal());
    const Vector form = random_vector(mesh.complex().size(1), 2);
    const HeatSolver inside(space.relative.complex, space.stars, Side::primal, 1, quick);
    const HeatSolver solver(mesh.complex(), stars, fixed, Side::primal, 1, quick);
    const Vector next = solver.step({Side::primal, 1, form}).values;
    const Vector there = inside.step({Side::primal, 1, space.relative.restrict(1, form)}).values;
    EXPECT_LE(relative_difference(next, space.relative.extend(1, there)), 1e-12);
    // the rows and columns of the edges inside, as they are
    const DenseMatrix whole(stars[1].matrix()), part(space.stars[1].matrix());
    const auto& kept = space.relative.cells[1];
    EXPECT_EQ(part, DenseMatrix(whole(kept, kept)));
}

TEST(HeatByStars, has_nothing_to_do_where_conditions_fix_all) {
    Mesh triangle;
    triangle.points.resize(3, 2);
    triangle.points << 0, 0, 1, 0, 0, 1;
    triangle.simplices.resize(1, 3);
    triangle.simplices << 0, 1, 2;
    const auto mesh = circumcentric(triangle);
    SparseMatrix twice(3, 3);
    twice.setIdentity();
    twice.coeffs() *= 2;
    const auto stars = mesh.stars().with(1, twice);
    BoundaryConditions fixed;
    fixed.everywhere = BoundaryCondition::essential;
    const auto space = conditioned_complex(mesh.complex(), stars, Side::primal, 1, fixed);
    EXPECT_EQ(space.stars[1].size(), 0);
    EXPECT_FALSE(space.stars[1].is_diagonal());
    const HeatSolver solver(mesh.complex(), stars, fixed, Side::primal, 1, quick);
    EXPECT_TRUE(solver.step({Side::primal, 1, Vector::Ones(3)}).values.isZero(0));
}

TEST(HeatByStars, shrinks_eigenforms_of_every_degree_by_galerkin) {
    for (const Mesh& input :
         {shaken(grid(5, 5), 0.42, 3), shaken(kuhn(3, 2), 0.3, 3), mesh_named("torus8x6")}) {
        const auto mesh = circumcentric(input);
        const auto stars = mesh.with_stars(StarKind::galerkin).stars();
        for (int k = 0; k <= mesh.dimension(); ++k)
            expect_eigenforms_to_shrink(mesh.complex(), stars, k);
    }
}

/// After a time far beyond all others of the mesh nothing but harmonic forms is left.
TEST(HeatByStars, leaves_harmonic_forms_after_the_longest_time) {
    const auto mesh = circumcentric(shaken(mesh_named("torus8x6"), 0.2, 3));
    const auto stars = mesh.with_stars(StarKind::hybrid).stars();
    ASSERT_TRUE(stars[0].is_diagonal() && !stars[1].is_diagonal());
    const Cochain form{Side::primal, 1, random_vector(mesh.complex().size(1), 2)};
    const Vector harmonic = hodge_decomposition(mesh.complex(), stars, form).harmonic.values;
    const HeatSolver solver(mesh.complex(), stars, Side::primal, 1, {.time_step = 1e8});
    EXPECT_LE(relative_difference(solver.step(form).values, harmonic), 1e-6);
    const HeatSolver brief(mesh.complex(), stars, Side::primal, 1, {.time_step = 1});
    EXPECT_GT(relative_difference(brief.step(form).values, harmonic), 1e-3);
}

/// What inverts a matrix acts by solving and has no sparse matrix, and so no diagonal; all else has
/// both.
TEST(OperatorsByStars, have_a_matrix_and_a_diagonal_where_no_matrix_is_inverted) {
    for (const Mesh& input : {shaken(grid(4, 4), 0.42, 3), shaken(kuhn(3, 2), 0.3, 3)}) {
        const auto mesh = circumcentric(input);
        const auto& complex = mesh.complex();
        const auto stars = mesh.with_stars(StarKind::galerkin).stars();
        const int n = mesh.dimension();
        for (int k = 0; k <= n; ++k) {
            const Vector x = random_vector(complex.size(k), 1);
            for (const auto& [A, inverts] :
                 {std::pair{symmetric_laplacian(complex, stars, k), k > 0},
                  std::pair{laplacian(complex, stars, k), true},
                  std::pair{Operator::star(stars[k]), false},
                  std::pair{dual_laplacian(complex, stars, n - k), true}}) {
                const Vector y = A * x;
                EXPECT_TRUE(y.allFinite());
                if (inverts) {
                    EXPECT_TRUE(says(refusal([&A = A] { A.matrix(); }), {"inverts", "star"}));
                    EXPECT_TRUE(says(refusal([&A = A] { A.diagonal(); }), {"inverts", "star"}));
                    continue;
                }
                EXPECT_LE(relative_difference(y, Vector(A.matrix() * x)), 1e-13) << "k = " << k;
                EXPECT_LE(relative_difference(A.diagonal(), Vector(A.matrix().diagonal())), 1e-13);
            }
            // columns of the operator, which is dense
            const Operator A = symmetric_laplacian(complex, stars, k);
            DenseMatrix columns(complex.size(k), complex.size(k));
            for (Index i = 0; i < columns.cols(); ++i)
                columns.col(i) = A * Vector::Unit(columns.cols(), i);
            EXPECT_LE((columns - columns.transpose()).norm(), 1e-11 * columns.norm());
            EXPECT_GT((columns + columns.transpose()).norm(), columns.norm());
        }
    }
}

/// The outward unit normals of the facets of tets, as they are.
Points outward_normals(const Discretization& mesh) {
    const Pieces& K = mesh.pieces();
    Points normals = Points::Zero(K.size(2), 3);
    for (Index t = 0; t < K.size(3); ++t)
        for (int i = 0; i <= 3; ++i) {
            const Index f = K.face(3, t, i);
            const auto corners = K.simplices(2).row(f);
            const auto point = [&](Index v) { return Eigen::Vector3d(mesh.points().row(v)); };
            const Eigen::Vector3d a = point(corners[0]);
            const Eigen::Vector3d normal =
                (point(corners[1]) - a).cross(point(corners[2]) - a).normalized();
            const double side = normal.dot(point(K.simplices(3)(t, i)) - a);
            normals.row(f) = side > 0 ? -normal : normal;
        }
    return normals;
}

/// How far the solution for a linear function is from it; its values are given where x < 1/2 on the
/// boundary, what flows out elsewhere.
double error_of_linear_solution(const Discretization& mesh) {
    const Vector slope = random_vector(3, 8);
    PoissonOptions options;
    options.boundary =
        essential_where(cell_centers(mesh, 2), [](const Vector& x) { return x[0] < 0.5; });
    const PoissonSolver solver(mesh, options);
    const Vector exact = solver.sites() * slope;
    const Vector outflow = outward_normals(mesh) * slope;
    return (solver.solve(Vector::Zero(exact.size()), exact, outflow).values - exact)
        .cwiseAbs()
        .maxCoeff();
}

TEST(PoissonByStars, has_linear_solutions_on_obtuse_tets) {
    const auto mesh =
        circumcentric(shaken(kuhn(3, 3), 0.08, 3), {.criterion = MergeCriterion::none});
    const auto by = [&](StarKind kind) {
        return error_of_linear_solution(mesh.with_stars(mesh.with_stars(kind).stars()));
    };
    EXPECT_LE(by(StarKind::galerkin), 1e-11);
    EXPECT_LE(by(StarKind::automatic), 1e-11);
    EXPECT_GT(by(StarKind::barycentric), 1e-3);
}

TEST(PoissonByStars, makes_the_star_of_conductivities) {
    const auto mesh = discretize(shaken(kuhn(3, 2), 0.25, 3));
    ASSERT_EQ(mesh.chosen_stars().kind, StarKind::galerkin);
    Vector kappa(mesh.complex().size(3));
    for (Index cell = 0; cell < kappa.size(); ++cell)
        kappa[cell] = 1 + cell % 3;
    for (const Side side : {Side::primal, Side::dual}) {
        const int k = side == Side::primal ? 1 : 2;
        const Vector weights = side == Side::primal ? kappa : Vector(kappa.cwiseInverse());
        const auto own = mesh.with_stars(
            mesh.stars().with(k, material_star(mesh, k, CellData::on_cells(weights))));
        const auto solve = [&](const Discretization& given, const Vector& conductivity) -> Vector {
            const PoissonSolver solver(
                given, {.side = side, .conductivity = CellData::on_cells(conductivity)});
            return solver.solve(Vector::Ones(solver.sites().rows()), solver.boundary_sites().col(0))
                .values;
        };
        EXPECT_EQ(solve(mesh, kappa), solve(own, {}));
        EXPECT_GT(relative_difference(solve(mesh, kappa), solve(mesh, {})), 1e-5);
    }
}

TEST(PoissonByStars, refuses_what_a_matrix_does_not_tell) {
    const auto mesh = circumcentric(shaken(kuhn(3, 2), 0.25, 3));
    const auto stars = mesh.with_stars(mesh.with_stars(StarKind::galerkin).stars());
    const Vector ones = Vector::Ones(mesh.complex().size(3));
    EXPECT_TRUE(
        says(refusal([&] { PoissonSolver(stars, {.conductivity = CellData::on_cells(ones)}); }),
             {"material_star"}));
}

} // namespace
} // namespace polydec::test::in_star_kinds
