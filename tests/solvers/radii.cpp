// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_radii {

struct Complex {
    SimplicialComplex complex;
    CellVolumes volumes;

    explicit Complex(const Mesh& mesh)
        : complex(mesh.simplices), volumes(circumcentric_volumes(complex, mesh.points)) {}

    bool has_spectrum(int k) const {
        return star(volumes, k).negatives().empty() && star(volumes, k).zeros().empty() &&
               (k == 0 || star(volumes, k - 1).zeros().empty());
    }
};

/// Meshes that nobody would wish for: obtuse, with slivers, of several components, graded.
std::vector<Mesh> hostile_meshes() {
    std::vector<Mesh> meshes{polygon_curve(),    theta_graph(),  two_components(),
                             obtuse_planar(),    obtuse_solid(), tilted_tetrahedra(),
                             projective_plane(), annulus(9),     triangle_soup(),
                             clifford_torus()};
    for (const std::uint64_t seed : {1, 2, 3, 4}) {
        meshes.push_back(perturbed(grid(5, 5), 0.06, seed));
        meshes.push_back(perturbed(kuhn(3, 2), 0.1, seed));
        meshes.push_back(perturbed(kuhn(4, 1), 0.1, seed));
        meshes.push_back(perturbed(well_centered(3), 0.02, seed));
    }
    DenseMatrix flat = DenseMatrix::Identity(2, 2);
    flat(1, 1) = 1e-4;
    meshes.push_back(transformed(perturbed(grid(3, 3), 0.05, 7), flat));
    const Mesh one = well_centered(3);
    meshes.push_back(united(one, transformed(one, DenseMatrix::Identity(2, 2), 1e-5, 3)));
    return meshes;
}

struct Found {
    Spectrum spectrum;
    ExtendedVector exact; ///< all eigenvalues, in more digits than a double has
    long double rounding; ///< of these
};

/// Of all degrees on both sides; made once.
const std::vector<Found>& hostile_spectra() {
    static const auto all = [] {
        std::vector<Found> result;
        for (const Mesh& mesh : hostile_meshes()) {
            const Complex cells(mesh);
            const int n = cells.complex.dimension();
            for (int k = 0; k <= n; ++k) {
                if (!cells.has_spectrum(k))
                    continue;
                const auto exact = extended_eigenvalues(cells.complex, cells.volumes, k);
                for (const Side side : {Side::primal, Side::dual}) {
                    if (side == Side::dual && k == n && branches(cells.complex))
                        continue;
                    const Index count = std::min<Index>(12, cells.complex.size(k));
                    const int degree = side == Side::primal ? k : n - k;
                    result.push_back(
                        {spectrum({{cells.complex, cells.volumes}, side, degree}, {.count = count}),
                         exact, 1e-17L * exact.cwiseAbs().maxCoeff()});
                }
            }
        }
        return result;
    }();
    return all;
}

TEST(Radii, hold_the_exact_eigenvalues_of_hostile_meshes) {
    for (const auto& [found, exact, rounding] : hostile_spectra()) {
        SCOPED_TRACE(testing::Message() << name(found.side) << found.degree);
        const double gap = static_cast<double>(exact[exact.size() - 1] - exact[0]);
        for (Index i = 0; i < found.eigenvalues.size(); ++i) {
            EXPECT_LE(std::abs(found.eigenvalues[i] - exact[i]), found.radii[i] + rounding) << i;
            EXPECT_LE(found.radii[i], 1e-6 * std::max(std::abs(found.eigenvalues[i]), gap)) << i;
        }
    }
    EXPECT_GE(hostile_spectra().size(), 50u);
}

/// The broken twin: much smaller radii would not hold them.
TEST(Radii, are_not_there_for_nothing) {
    Index outside = 0;
    for (const auto& [found, exact, rounding] : hostile_spectra())
        for (Index i = 0; i < found.eigenvalues.size(); ++i)
            outside += std::abs(found.eigenvalues[i] - exact[i]) > 1e-4 * found.radii[i] + rounding;
    EXPECT_GT(outside, 0);
}

/// Two triangles of height h on both sides of an edge, and one of ordinary shape. Values: 60
/// digits.
TEST(ThreeTriangles, have_small_eigenvalues_beside_a_huge_one) {
    const auto check = [](double h, double depth, const std::array<double, 3>& exact) {
        const Complex cells(made_of({{0, 0}, {1, 0}, {0.5, -h}, {0.5, h}, {0.5, -depth}},
                                    {{0, 1, 3}, {0, 1, 2}, {0, 2, 4}}));
        for (const Side side : {Side::primal, Side::dual}) {
            const auto found = spectrum(
                {{cells.complex, cells.volumes}, side, side == Side::primal ? 2 : 0}, {.count = 3});
            for (Index i = 0; i < 3; ++i) {
                EXPECT_NEAR(found.eigenvalues[i], exact[i], found.radii[i]) << i;
                EXPECT_NEAR(found.eigenvalues[i], exact[i], 1e-9 * std::abs(exact[i])) << i;
                EXPECT_LE(found.radii[i], 1e-6 * std::abs(exact[i])) << i;
            }
            EXPECT_TRUE(found.rough.empty());
        }
    };
    check(std::ldexp(1.0, -19), 0.5,
          {-4194304.0000610352727, -1.5258920029959102858e-5, 15.999984741341903849});
    check(1e-6, 1, {-3999988.000052, -1.600000000016e-5, 15.999984000096});
}

/// An edge of 3e-15 among nine of length 1 around a vertex: eigenvalues of 1e29 beside 2.
TEST(StarOfEdges, with_one_too_short_is_refused_or_right) {
    Mesh star;
    star.points = Points::Zero(11, 1);
    star.simplices.resize(10, 2);
    for (Index i = 1; i <= 10; ++i) {
        star.points(i, 0) = i == 4 ? 3e-15 : 1;
        star.simplices.row(i - 1) << 0, i;
    }
    const Complex cells(star);
    Index refused = 0;
    for (const int k : {0, 1})
        try {
            const auto found =
                spectrum({{cells.complex, cells.volumes}, Side::primal, k}, {.count = 4});
            const ExtendedVector exact = extended_eigenvalues(cells.complex, cells.volumes, k);
            for (Index i = 0; i < 4; ++i) {
                EXPECT_LE(std::abs(found.eigenvalues[i] - exact[i]),
                          found.radii[i] + 1e-17L * exact.maxCoeff());
                EXPECT_TRUE(std::isfinite(found.radii[i]));
            }
        } catch (const SolverFailure& refusal) {
            ++refused;
            EXPECT_NE(std::string_view(refusal.what()).find("cannot be"), std::string_view::npos)
                << refusal.what();
        }
    EXPECT_GE(refused, 1);
}

TEST(CertifiedEigensolver, works_at_any_scale) {
    for (const double a : {1e-300, 1e-150, 1.0, 1e150, 1e300})
        for (const double m : {1e-300, 1.0, 1e300}) {
            if (const double ratio = std::log10(a) - std::log10(m); std::abs(ratio) > 301)
                continue;
            SCOPED_TRACE(testing::Message() << a << ' ' << m);
            SparseMatrix A(60, 60);
            for (Index i = 0; i < 60; ++i)
                A.insert(i, i) = a * (1 + i / 8);
            const auto pairs = CertifiedEigensolver(A, Vector::Constant(60, m)).smallest(9);
            for (Index i = 0; i < 9; ++i)
                EXPECT_NEAR(pairs.values[i] / (a / m), 1 + i / 8, 1e-12);
            EXPECT_LE(pairs.radii.maxCoeff(), 1e-9 * (a / m));
            EXPECT_TRUE(pairs.certificate.complete);
        }
}

TEST(CertifiedEigensolver, names_values_that_rounding_hides) {
    const Vector v = (Vector(3) << 1, 2, 3).finished();
    const DenseMatrix Q = DenseMatrix::Identity(3, 3) - v * v.transpose() / 7;
    const Vector values = (Vector(3) << 1e9, 1.1e9, 1e20).finished();
    const SparseMatrix A = DenseMatrix(Q * values.asDiagonal() * Q).sparseView();
    const auto pairs = CertifiedEigensolver(A, Vector::Ones(3)).smallest(2);
    EXPECT_EQ(pairs.rough, std::vector<Index>{1});
    EXPECT_GT(pairs.radii[0], 1);
    EXPECT_TRUE(CertifiedEigensolver(A, Vector::Ones(3)).smallest(3).radii[2] < 1e-6 * 1e20);
}

TEST(ManyComponents, have_all_copies_of_an_eigenvalue_by_a_count_of_them) {
    constexpr Index copies = 60;
    Mesh spheres = icosphere(1);
    for (Index i = 1; i < copies; ++i)
        spheres = united(spheres, icosphere(1));
    const Complex cells(spheres);
    Index rounds = 0;
    const auto found = spectrum({{cells.complex, cells.volumes}, Side::primal, 0},
                                {.count = copies + 1, .progress = [&](std::string_view what) {
                                     rounds += what == "iterating" ? 1 : 0;
                                 }});
    EXPECT_EQ(found.certificate.below_shift, 4 * copies);
    EXPECT_TRUE(found.certificate.complete);
    EXPECT_LE(rounds, 3);
}

TEST(SpectrumOfTwoSpheres, is_that_of_the_large_one_and_zeros_of_both) {
    const Mesh sphere = icosphere(3);
    const Complex one(sphere);
    for (const auto& [size, rounding] : {std::pair{1e-5, 1e-7}, {1e-6, 1e-4}}) {
        const Complex both(
            united(sphere, transformed(sphere, DenseMatrix::Identity(3, 3), size, 5)));
        for (const int k : {0, 1, 2}) {
            const Index zeros = k == 1 ? 0 : 1; // of each sphere
            const Vector single =
                spectrum({{one.complex, one.volumes}, Side::primal, k}, {.count = 9}).eigenvalues;
            const auto found =
                spectrum({{both.complex, both.volumes}, Side::primal, k}, {.count = 9 + zeros});
            EXPECT_LE(found.eigenvalues.head(2 * zeros).norm(), 1e-9);
            EXPECT_WITHIN(found.eigenvalues.tail(9 - zeros), single.tail(9 - zeros), rounding);
            EXPECT_LE(found.radii.maxCoeff(), 10 * rounding);
            EXPECT_TRUE(found.certificate.complete);
        }
    }
}

/// Eigenvalues from 2 to 1e9 and more: the small ones must not count as zeros beside the large.
TEST(CoexactSpectrum, spans_two_spheres_of_very_different_size) {
    const Mesh sphere = icosphere(2);
    const Complex one(sphere);
    const Mesh small = transformed(sphere, DenseMatrix::Identity(3, 3), 1e-4, 5);
    const Complex both(united(sphere, small));
    const Index coexact = one.complex.size(2) - 1;
    const SpectrumOptions all{.count = coexact};
    const auto single = coexact_spectrum({{one.complex, one.volumes}, Side::primal, 1}, all);
    const auto twice =
        coexact_spectrum({{both.complex, both.volumes}, Side::primal, 1}, {.count = 2 * coexact});
    ASSERT_EQ(twice.eigenvalues.size(), 2 * coexact);
    for (Index i = 0; i < coexact; ++i) {
        EXPECT_NEAR(twice.eigenvalues[i], single.eigenvalues[i], 1e-8 * single.eigenvalues[i]);
        EXPECT_NEAR(twice.eigenvalues[coexact + i] * 1e-8, single.eigenvalues[i],
                    1e-6 * single.eigenvalues[i]);
    }
    EXPECT_GT(twice.eigenvalues[2 * coexact - 1], 1e7 * twice.eigenvalues[0]);
    EXPECT_EQ(twice.radii.size(), 2 * coexact);
    EXPECT_LE((twice.radii.array() / twice.eigenvalues.array()).maxCoeff(), 1e-6);
}

} // namespace polydec::test::in_radii
