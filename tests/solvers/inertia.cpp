// SPDX-License-Identifier: MIT
#include "backends/spectra/inertia.h"

#include "backends/spectra/shifted_solver.h"
#include "base/block_matrix.h"
#include "solvers/spectra/laplacian_pencil.h"
#include "tests/support/test.h"

namespace polydec::test::in_inertia {

constexpr double infinity = std::numeric_limits<double>::infinity();

ShiftedMatrices shifted(const SparseMatrix& B) {
    return {std::make_shared<const SparseMatrix>(B), diagonal_matrix(Vector::Ones(B.rows()))};
}

/// B has eigenvalues .001 and 6.001; with errors of 6e-4 in each entry the first may be negative.
TEST(Inertia, is_not_told_where_errors_of_entries_could_change_it) {
    DenseMatrix B{{3.001, -3}, {-3, 3.001}};
    const auto below = [&](double error) {
        const Doubt doubt{Vector::Constant(2, 3.001), 2 * error / 3.001, 0};
        return InertiaCounter(shifted(sparse(B)), "auto", 0, doubt).below(0, 1e-3);
    };
    EXPECT_EQ(below(6e-4), std::nullopt);
    EXPECT_EQ(below(1e-6), Index{0});
}

/// Eigenvalues near 1 beside 1e20, which a norm of all errors would hide.
TEST(Inertia, of_graded_matrices_is_that_of_their_small_entries) {
    const Vector diagonal = (Vector(4) << 1, 2, 1e20, 3e20).finished();
    SparseMatrix B(4, 4);
    for (Index i = 0; i < 4; ++i)
        B.insert(i, i) = diagonal[i];
    InertiaCounter counter(shifted(B), "auto", 0, {diagonal, 1e-15, 1e-15});
    EXPECT_EQ(counter.below(1.5, 0.5), Index{1});
    EXPECT_EQ(counter.below(2.5, 0.5), Index{2});
    EXPECT_EQ(counter.below(2e20, 1e20), Index{3});
}

/// Two triangles of height 1e-6 on both sides of an edge, and one of ordinary shape. Their
/// densities have the eigenvalues -3999988.000052, -1.600000000016e-5 and 15.999984000096, by 60
/// digits.
TEST(Inertia, of_three_triangles_counts_small_eigenvalues_beside_a_huge_one) {
    const auto mesh = circumcentric(made_of({{0, 0}, {1, 0}, {0.5, -1e-6}, {0.5, 1e-6}, {0.5, -1}},
                                            {{0, 1, 3}, {0, 1, 2}, {0, 2, 4}}),
                                    {.criterion = MergeCriterion::none, .tolerance = 0});
    const ScaledPencil pencil(laplacian_pencil(mesh.complex(), mesh.stars(), 2));
    const double unit = pencil.eigenvalue(1);
    InertiaCounter counter(pencil.matrices(), "auto", 2, pencil.doubt());
    const auto below = [&](double shift, double gap) {
        return counter.below(shift / unit, gap / unit);
    };
    EXPECT_EQ(below(-1e7, 6e6), Index{0});
    EXPECT_EQ(below(-1, 0.9), Index{1});
    EXPECT_EQ(below(-1e-6, 1e-5), Index{2});
    EXPECT_EQ(below(1e-6, 1e-5), Index{2});
    EXPECT_EQ(below(1, 0.9), Index{2});
    EXPECT_EQ(below(17, 0.9), Index{3});
}

/// Seen from a shift below -9e7, zero and the values behind it are one.
TEST(CertifiedEigensolver, finds_small_values_behind_a_few_huge_negative_ones) {
    constexpr Index size = 1000;
    SparseMatrix A(size, size);
    for (Index i = 0; i < size; ++i)
        A.insert(i, i) = i < 3 ? -9e7 / (1 + 5 * i) : 20.0 * (i - 3);
    const auto pairs = CertifiedEigensolver(A, Vector::Ones(size)).smallest(6);
    const Vector exact = (Vector(6) << -9e7, -1.5e7, -9e7 / 11, 0, 20, 40).finished();
    for (Index i = 0; i < 6; ++i)
        EXPECT_NEAR(pairs.values[i], exact[i], pairs.radii[i]);
    EXPECT_LE(pairs.radii.tail(3).maxCoeff(), 1e-6);
    EXPECT_TRUE(pairs.certificate.complete);
}

std::string refused(const Pencil& pencil) {
    const std::string message = refusal([&] { ScaledPencil{pencil}; });
    return message.substr(message.find(": ") + 2);
}

TEST(ShiftedSolver, solves_alike_after_it_made_room) {
    DenseMatrix A{{2, -1, 0}, {-1, 2, -1}, {0, -1, 2}};
    const ScaledPencil pencil({.C = sparse(A), .M = Vector{{1, 4, 16}}});
    MatrixFacts facts;
    facts.symmetry = Symmetry::symmetric;
    ShiftedSolver solver(pencil, "auto", facts);
    for (const double shift : {-1.0, 0.0, 0.5}) {
        solver.set(shift, Definiteness::indefinite);
        const DenseMatrix Y = DenseMatrix::Identity(3, 2), before = solver.solve(Y);
        const std::string engine = solver.engine();
        solver.make_room(0);
        EXPECT_EQ(solver.engine(), engine);
        EXPECT_EQ(solver.solve(Y), before);
        EXPECT_EQ(solver.shift(), shift);
    }
}

TEST(PencilRefuses, what_is_no_number_or_no_share) {
    DenseMatrix A = DenseMatrix::Identity(2, 2);
    const Vector ones = Vector::Ones(2);
    A(1, 1) = infinity;
    EXPECT_SAYS(refused({.C = sparse(A), .M = ones}), "symmetric", "C", "finite");
    A << 1, 2, 3, 4;
    EXPECT_SAYS(refused({.C = sparse(A), .M = ones}), "symmetric", "C", "(0, 1)");
    DenseMatrix graded = Vector{{1e15, 1, 2}}.asDiagonal();
    graded(1, 2) = 0.5;
    EXPECT_SAYS(refused({.C = sparse(graded), .M = Vector(Vector::Ones(3))}), "C", "(1, 2)");
    A = DenseMatrix::Identity(2, 2);
    EXPECT_SAYS(refused({.C = sparse(A), .M = ones, .mass_uncertainty = -1}), "M", "-1", "0", "1");
    EXPECT_SAYS(refused({.C = sparse(A), .M = ones, .mass_uncertainty = 1}), "M", "1", "0", "1");
    EXPECT_SAYS(refused({.parts = {{sparse(A), ones, -ones}}, .M = ones}), "uncertainty", "F^T W F",
                "finite");
    EXPECT_SAYS(refused({.C = sparse(A), .M = (Vector(2) << 1e-300, 1e300).finished()}),
                "entries of A", "scale");
    A(0, 0) = std::numeric_limits<double>::quiet_NaN();
    EXPECT_SAYS(refused({.parts = {{sparse(A), ones}}, .M = ones}), "number", "F^T W F", "finite");
}

TEST(Pencil, of_matrices_that_rounding_makes_unsymmetric_is_that_of_means_of_opposite_entries) {
    DenseMatrix C{{2, -1, 0}, {-1, 2, -1}, {0, -1, 2}}, M{{4, 1, 0}, {1, 4, 1}, {0, 1, 4}};
    C(0, 1) += 1e-12;
    M(1, 2) -= 2e-12;
    const auto pairs = [](const DenseMatrix& A, const DenseMatrix& B) {
        return CertifiedEigensolver({.C = sparse(A), .M = sparse(B)}).smallest(2);
    };
    const auto found = pairs(C, M),
               expected = pairs((C + C.transpose()) / 2, (M + M.transpose()) / 2);
    EXPECT_EQ(found.values, expected.values);
    EXPECT_EQ(found.radii, expected.radii);
}

TEST(CoexactSpectrum, of_forms_that_there_are_not_is_refused_at_once) {
    const auto mesh = circumcentric(kuhn(3, 6));
    const auto refused = [&](int k, Index count) {
        return refusal([&] {
            coexact_spectrum({{mesh.complex(), mesh.volumes()}, Side::primal, k}, {.count = count});
        });
    };
    EXPECT_SAYS(refused(3, 1), "1 coexact 3-forms", "0");
    EXPECT_SAYS(refused(0, 343), "343 coexact 0-forms", "342");
    EXPECT_SAYS(refused(0, 0), "0 coexact 0-forms", "342");
    EXPECT_SAYS(refused(0, -3), "-3 coexact 0-forms", "342");
    EXPECT_SAYS(refused(2, std::numeric_limits<Index>::max()), "2147483647 coexact 2-forms", "216");
    EXPECT_SAYS(refused(4, 1), "degree 4", "dimension 3");
}

/// A strip of triangles a hundred thousand times as high as wide.
TEST(CoexactSpectrum, names_its_own_rough_values) {
    constexpr Index count = 20;
    constexpr double width = 1e-5;
    const double c = std::cos(0.3), s = std::sin(0.3);
    Mesh strip;
    strip.points.resize(2 * count + 1, 2);
    for (Index i = 0; i <= count; ++i)
        strip.points.row(i) << c * i * width, s * i * width;
    for (Index i = 0; i < count; ++i)
        strip.points.row(count + 1 + i) << c * (i + 0.5) * width - s, s * (i + 0.5) * width + c;
    strip.simplices.resize(2 * count - 1, 3);
    for (Index i = 0; i < count; ++i)
        strip.simplices.row(i) << i, i + 1, count + 1 + i;
    for (Index i = 0; i + 1 < count; ++i)
        strip.simplices.row(count + i) << i + 1, count + 2 + i, count + 1 + i;
    const auto mesh = circumcentric(strip);
    const auto found =
        coexact_spectrum({{mesh.complex(), mesh.volumes()}, Side::primal, 0}, {.count = 1});
    ASSERT_EQ(found.eigenvalues.size(), 1);
    for (const Index i : found.rough)
        EXPECT_EQ(i, 0);
}

/// Lengths have been computed from points, and their last digits are much in thin triangles. Values
/// of three triangles around a point, one of them of height h: 60 digits.
TEST(RadiiAfterFlips, hold_what_the_last_digits_of_lengths_can_do) {
    const auto check = [](const std::vector<std::vector<double>>& points, double exact) {
        const Mesh mesh = made_of(points, {{0, 1, 2}, {0, 2, 3}, {2, 1, 3}});
        const auto found = spectrum({circumcentric(mesh, {.delaunay = Delaunay::flips}),
                                     Side::dual,
                                     0,
                                     {BoundaryCondition::natural}},
                                    {.count = 3});
        EXPECT_LE(std::abs(found.eigenvalues[0]), found.radii[0]);
        EXPECT_NEAR(found.eigenvalues[1], exact, found.radii[1]);
        EXPECT_NEAR(found.eigenvalues[2], exact, found.radii[2]);
        EXPECT_LE(found.radii[2], 0.1);
    };
    const std::vector<double> origin{0, 0}, right{0.955336489125606, 0.29552020666133955};
    const std::vector<double> top{0.24125207923373135, 0.9120292946311547};
    check({origin, right, {0.4490051946869682, 0.13890405049572083}, top}, 16.057493863200187792);
    check({origin, right, {0.4490078543688282, 0.13889545246731871}, top}, 16.057776683460156459);
}

} // namespace polydec::test::in_inertia
