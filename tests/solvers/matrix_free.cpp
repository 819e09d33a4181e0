// SPDX-License-Identifier: MIT
#include "backends/linear/matrix_free.h"

#include "backends/registry.h"
#include "base/errors.h"
#include "dec/discretization.h"
#include "dec/operators.h"
#include "meshes/generate.h"
#include "tests/support/circumcentric.h"
#include "tests/support/matrices.h"
#include "tests/support/refusal.h"
#include "tests/support/says.h"

#include <gtest/gtest.h>

namespace polydec::test::in_matrix_free {
namespace {

/// star_k + (star times Laplacian) on k-forms: positive where the stars are.
Operator positive(const Discretization& cells, int k) {
    return symmetric_laplacian(cells, k) + Operator::weights(star(cells, k).diagonal());
}

SymmetricOperator shifted_laplacian(const Discretization& cells, int k) {
    return {cells.complex().size(k),
            [A = positive(cells, k)](const Vector& x, Vector& y) { y = A * x; }};
}

Vector diagonal(const Discretization& cells, int k) {
    return positive(cells, k).diagonal();
}

TEST(matrix_free, solutions_are_those_with_a_matrix_for_every_degree) {
    for (const Mesh& mesh : {torus(24, 12), well_centered(8), kuhn(3, 4), kuhn(4, 2)}) {
        const auto cells = circumcentric(mesh);
        for (int k = 0; k <= cells.dimension(); ++k) {
            const SparseMatrix A = positive(cells, k);
            const auto direct = make_linear_solver("eigen.ldlt");
            direct->factorize(
                A, {.symmetry = Symmetry::symmetric, .definiteness = Definiteness::positive});
            const Vector b = random_vector(cells.complex().size(k), 5);
            SolveReport report;
            const Vector x =
                solve_matrix_free(shifted_laplacian(cells, k), b, diagonal(cells, k), {}, &report);
            EXPECT_LE((x - direct->solve(b)).norm(), 1e-9 * x.norm());
            EXPECT_LE(report.residual, 1e-11);
            EXPECT_GT(report.iterations, 0);
        }
    }
}

TEST(matrix_free, the_diagonal_saves_iterations_where_cells_differ_in_size) {
    Mesh mesh = well_centered(12);
    mesh.points = mesh.points.array().pow(3).matrix(); // small cells near the corner
    const auto cells = circumcentric(mesh, {.criterion = MergeCriterion::none});
    const Vector mass = star(cells.volumes(), 0).diagonal().cwiseAbs();
    const SymmetricOperator A{cells.complex().size(0),
                              [&](const Vector& x, Vector& y) { y = mass.cwiseProduct(x); }};
    const Vector b = random_vector(A.size, 6);
    SolveReport with, without;
    solve_matrix_free(A, b, mass, {}, &with);
    solve_matrix_free(A, b, {}, {}, &without);
    EXPECT_LE(with.iterations, 2);
    EXPECT_GT(without.iterations, 20);
}

TEST(matrix_free, tiny_and_zero_right_hand_sides_have_their_solutions) {
    const auto cells = circumcentric(torus(12, 6));
    const auto A = shifted_laplacian(cells, 0);
    const Vector b = random_vector(A.size, 7);
    const Vector x = solve_matrix_free(A, b);
    EXPECT_LE((solve_matrix_free(A, 1e-200 * b) - 1e-200 * x).norm(), 1e-9 * 1e-200 * x.norm());
    EXPECT_EQ(solve_matrix_free(A, 0 * b).norm(), 0);
}

TEST(matrix_free, what_cannot_be_solved_is_refused) {
    const auto cells = circumcentric(torus(12, 6));
    const SymmetricOperator A = shifted_laplacian(cells, 0);
    const Vector b = Vector::Ones(A.size);
    const SymmetricOperator without_constants{
        A.size, [&](const Vector& x, Vector& y) { y = symmetric_laplacian(cells, 0) * x; }};
    EXPECT_THROW(solve_matrix_free(without_constants, b), SolverFailure);
    EXPECT_TRUE(says(refusal([&] { solve_matrix_free(A, Vector::Ones(3)); }),
                     {"eigen.cg", "3 values", "diagonal", "0", "72 unknowns"}));
    Vector zero = b;
    zero[5] = 0;
    EXPECT_TRUE(says(refusal([&] { solve_matrix_free(A, b, zero); }),
                     {"eigen.cg", "entry 5", "diagonal", "0"}));
    const SymmetricOperator nothing{A.size, [](const Vector&, Vector& y) { y = Vector(0); }};
    EXPECT_THROW(solve_matrix_free(nothing, b), SolverFailure);
}

} // namespace
} // namespace polydec::test::in_matrix_free
