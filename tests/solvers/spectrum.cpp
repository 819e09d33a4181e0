// SPDX-License-Identifier: MIT
#include "tests/support/scales.h"
#include "tests/support/test.h"

namespace polydec::test::in_spectrum {

struct Case {
    std::string name;
    std::function<Mesh()> make;
};

void PrintTo(const Case& instance, std::ostream* out) {
    *out << instance.name;
}

class Spectra : public testing::TestWithParam<Case> {};

/// The largest eigenvalue tells what rounding leaves of a zero one.
double rounding(const Vector& exact) {
    return 1e-12 * exact[exact.size() - 1];
}

std::vector<Index> counts_up_to(Index size) {
    std::vector<Index> counts;
    for (const Index count : {4, 11, 25, 60})
        if (count < size)
            counts.push_back(count);
    if (size <= 60)
        counts.push_back(size);
    return counts;
}

void expect_agreement(const Spectrum& found, const Vector& exact) {
    for (Index i = 0; i < found.eigenvalues.size(); ++i)
        EXPECT_NEAR(found.eigenvalues[i], exact[i], 1e-8 * exact[i] + rounding(exact)) << i;
    EXPECT_TRUE(std::is_sorted(found.eigenvalues.begin(), found.eigenvalues.end()));
}

void expect_proof(const Spectrum& found, const Vector& exact) {
    const auto& certificate = found.certificate;
    EXPECT_TRUE(certificate.complete);
    EXPECT_EQ(certificate.below_shift, certificate.returned_below_shift);
    EXPECT_EQ(certificate.below_shift, number_below(exact, certificate.shift));
    EXPECT_GE(certificate.below_shift, found.eigenvalues.size());
}

void expect_orthonormal_modes(const Spectrum& found, const Vector& star_of_cells) {
    const Vector star = found.side == Side::primal ? star_of_cells : star_of_cells.cwiseInverse();
    const DenseMatrix gram = found.modes.transpose() * star.asDiagonal() * found.modes;
    EXPECT_TRUE(gram.isIdentity(1e-9))
        << (gram - DenseMatrix::Identity(gram.rows(), gram.cols())).cwiseAbs().maxCoeff();
}

/// Of the modes themselves, by an operator that the solver does not use.
double largest_defect(const Discretization& mesh, const Spectrum& found) {
    const SparseMatrix delta = found.side == Side::primal
                                   ? laplacian({mesh.complex(), mesh.volumes()}, found.degree)
                                   : dual_laplacian({mesh.complex(), mesh.volumes()}, found.degree);
    double largest = 0;
    for (Index i = 0; i < found.modes.cols(); ++i) {
        const Vector x = found.modes.col(i);
        largest = std::max(largest, (delta * x - found.eigenvalues[i] * x).norm() / x.norm());
    }
    return largest;
}

TEST_P(Spectra, agree_with_dense_solutions_and_are_proved_complete) {
    const auto mesh = circumcentric(GetParam().make());
    const int n = mesh.dimension();
    for (int k = 0; k <= n; ++k) {
        const Vector exact = dense_spectrum(mesh, k);
        for (const Side side : {Side::primal, Side::dual})
            for (const Index count : counts_up_to(static_cast<Index>(exact.size()))) {
                const int degree = side == Side::primal ? k : n - k;
                SCOPED_TRACE(testing::Message() << name(side) << ' ' << degree << ", " << count);
                const auto found = spectrum({mesh, side, degree}, {.count = count});
                ASSERT_EQ(found.eigenvalues.size(), count);
                ASSERT_EQ(found.residuals.size(), count);
                expect_agreement(found, exact);
                expect_proof(found, exact);
                expect_orthonormal_modes(found, star(mesh.volumes(), k).diagonal());
                EXPECT_LE(found.residuals.maxCoeff(), 1e-7 * exact[exact.size() - 1]);
                EXPECT_LE(largest_defect(mesh, found), 1e-7 * exact[exact.size() - 1]);
            }
    }
}

TEST_P(Spectra, have_as_many_zeros_as_the_Betti_number) {
    const auto mesh = circumcentric(GetParam().make());
    const auto betti = betti_numbers(mesh.complex());
    for (int k = 0; k <= mesh.dimension(); ++k) {
        const Index count = std::min<Index>(betti[k] + 3, mesh.complex().size(k));
        const Vector values = spectrum({mesh, Side::primal, k}, {.count = count}).eigenvalues;
        const double typical = laplacian({mesh.complex(), mesh.volumes()}, k).diagonal().mean();
        EXPECT_EQ(number_below(values, 1e-10 * typical), betti[k]) << k;
    }
}

TEST(SpectraOfManyPieces, have_a_zero_for_each_and_for_each_hole) {
    const Index pieces = 60;
    const Mesh square = grid(2, 2);
    Mesh many = square;
    for (Index i = 1; i < pieces; ++i)
        many = united(many, transformed(square, DenseMatrix::Identity(2, 2), 1, 2.0 * i));
    const auto mesh = discretize(many);
    for (const Side side : {Side::primal, Side::dual})
        for (const Index count : {4, 60}) {
            const int degree = side == Side::primal ? 0 : 2;
            Index first = 0; // how many are known when the first are told of
            const auto listen = [&](const DenseMatrix& vectors) {
                first = first == 0 ? static_cast<Index>(vectors.cols()) : first;
            };
            const auto found = spectrum({mesh, side, degree}, {.count = count, .found = listen});
            EXPECT_LE(found.eigenvalues.cwiseAbs().maxCoeff(), 1e-12);
            EXPECT_TRUE(found.certificate.complete);
            EXPECT_EQ(found.certificate.below_shift, pieces);
            expect_orthonormal_modes(found, star(mesh.volumes(), 0).diagonal());
            EXPECT_GT(first, pieces); // no zero is searched for
        }
}

INSTANTIATE_TEST_SUITE_P(Meshes, Spectra,
                         testing::Values(Case{"icosphere1", [] { return icosphere(1); }},
                                         Case{"icosphere2", [] { return icosphere(2); }},
                                         Case{"icosphere3", [] { return icosphere(3); }},
                                         Case{"uv_sphere8x6", [] { return uv_sphere(8, 6); }},
                                         Case{"uv_sphere16x9", [] { return uv_sphere(16, 9); }},
                                         Case{"goldberg1", [] { return goldberg(1); }},
                                         Case{"goldberg3", [] { return goldberg(3); }},
                                         Case{"torus16x8", [] { return torus(16, 8); }},
                                         Case{"annulus9", [] { return annulus(9); }},
                                         Case{"two_components", [] { return two_components(); }},
                                         Case{"well_centered3", [] { return well_centered(3); }},
                                         Case{"squares9", [] { return kuhn(2, 9); }},
                                         Case{"cubes4", [] { return kuhn(3, 4); }},
                                         Case{"cube_ring", [] { return hollow_cube(); }},
                                         Case{"tesseracts2", [] { return kuhn(4, 2); }}),
                         [](const auto& instance) { return instance.param.name; });

void expect_multiplets(const Vector& values, std::vector<std::pair<double, Index>> multiplets) {
    Index i = 0;
    for (const auto& [value, copies] : multiplets)
        for (Index copy = 0; copy < copies; ++copy, ++i)
            EXPECT_NEAR(values[i], value, 0.5e-3) << i;
}

/// Values from an independent program: frequency 16.
TEST(GoldbergSpectrum, is_that_of_the_sphere_to_three_digits) {
    const auto mesh = circumcentric(goldberg(16));
    expect_multiplets(spectrum({mesh, Side::primal, 0}, {.count = 9}).eigenvalues,
                      {{0, 1}, {2.000, 3}, {5.997, 5}});
    expect_multiplets(spectrum({mesh, Side::primal, 2}, {.count = 9}).eigenvalues,
                      {{0, 1}, {2.001, 3}, {5.994, 5}});
    expect_multiplets(spectrum({mesh, Side::primal, 1}, {.count = 16}).eigenvalues,
                      {{2.000, 3}, {2.001, 3}, {5.994, 5}, {5.997, 5}});
}

TEST(GradedBoxes, have_spectra_in_every_degree) {
    const auto mesh = circumcentric(graded(3, 4, 3e4));
    for (int k = 0; k <= 3; ++k)
        EXPECT_EQ(spectrum({mesh, Side::primal, k}, {.count = 3}).eigenvalues.size(), 3) << k;
}

/// Linear functions on a grid with diagonals: lambda_h = lambda (1 + lambda h^2 / 12) for cosines
/// of one coordinate.
TEST(Coarseness, of_a_grid_is_twice_the_error_of_linear_functions) {
    constexpr double exact = 9 * std::numbers::pi * std::numbers::pi;
    for (const int n : {16, 32}) {
        const auto mesh =
            discretize(grid(n, n), {.criterion = MergeCriterion::none, .star = StarKind::galerkin});
        // 0, 1, 1, 2, 4, 4, 5, 5, 8, 9 times pi^2
        const auto found = spectrum({mesh, Side::primal, 0}, {.count = 10});
        EXPECT_NEAR(*found.coarseness / (found.eigenvalues[9] / exact - 1), 2, 0.1) << n;
        EXPECT_EQ(says(advice_of_shape(found), {"shape_spectrum", "coarse"}), n == 16);
    }
}

TEST(Coarseness, is_that_of_eigenvalues_that_can_be_enclosed) {
    const auto square = circumcentric(grid(4, 4));
    const auto cube = circumcentric(kuhn(3, 2));
    BoundaryConditions pinned = built_in_conditions(Side::primal);
    pinned.fixed_vertices.assign(square.complex().size(0), false);
    pinned.fixed_vertices[0] = true;
    EXPECT_FALSE(spectrum({square, Side::primal, 0, pinned}, {.count = 3}).coarseness);
    EXPECT_TRUE(spectrum({square, Side::dual, 1}, {.count = 3}).coarseness);
    const BoundaryConditions robin = robin_elsewhere({BoundaryCondition::natural}, 1);
    for (const Side side : {Side::primal, Side::dual})
        for (const int degree : {0, 1})
            EXPECT_EQ(spectrum({square, side, degree, robin}, {.count = 3}).coarseness.has_value(),
                      degree == 0);
    EXPECT_FALSE(spectrum({cube, Side::primal, 1}, {.count = 3}).coarseness);
    EXPECT_EQ(spectrum({cube, Side::dual, 0}, {.count = 3}).coarseness, 0);
}

} // namespace polydec::test::in_spectrum
