// SPDX-License-Identifier: MIT
//
// Certified spectra whose inner products are matrices.
#include "backends/spectra/inertia.h"
#include "backends/spectra/scaled_pencil.h"
#include "solvers/spectra/laplacian_pencil.h"
#include "tests/support/test.h"

namespace polydec::test::in_spectra_of_stars {

constexpr std::array kinds{StarKind::galerkin, StarKind::hybrid, StarKind::barycentric};

/// How many of the values have the eigenvalue of their number within their radius, and what those
/// of long double may be off by.
Index number_enclosed(const Spectrum& found, const ExtendedVector& exact) {
    const long double own = 1e-17L * exact.cwiseAbs().maxCoeff();
    Index inside = 0;
    for (Index i = 0; i < found.eigenvalues.size(); ++i)
        inside += std::abs(found.eigenvalues[i] - exact[i]) <= found.radii[i] + own ? 1 : 0;
    return inside;
}

class SpectraOfStars : public testing::TestWithParam<std::string> {};

/// Against all eigenvalues of dense matrices in more digits than a double has.
TEST_P(SpectraOfStars, hold_the_eigenvalues_within_their_radii) {
    const auto mesh = circumcentric(mesh_named(GetParam()), {.tolerance = tolerance});
    const auto betti = betti_numbers(mesh.complex());
    for (const StarKind kind : kinds) {
        if (kind == StarKind::hybrid && mesh.dimension() != 2)
            continue;
        const auto stars = mesh.with_stars(kind).stars();
        for (int k = 0; k <= mesh.dimension(); ++k) {
            if (mesh.complex().size(k) > 80)
                continue;
            const auto exact = extended_eigenvalues(mesh.complex(), stars, k);
            const Index count = std::min<Index>(mesh.complex().size(k), betti[k] + 6);
            const auto found =
                spectrum({{mesh.complex(), stars}, Side::primal, k}, {.count = count});
            EXPECT_TRUE(found.certificate.complete);
            EXPECT_EQ(number_enclosed(found, exact), count) << name(kind) << ", k = " << k << "\n"
                                                            << exact.head(count).transpose() << "\n"
                                                            << found.eigenvalues.transpose() << "\n"
                                                            << found.radii.transpose();
            EXPECT_LE(found.radii.maxCoeff(),
                      1e-9 * std::abs(static_cast<double>(exact.tail(1)[0])))
                << name(kind) << ", k = " << k;
            for (Index i = 0; i < betti[k]; ++i)
                EXPECT_LE(std::abs(found.eigenvalues[i]), found.radii[i]) << name(kind);

            if (k == mesh.dimension() && branches(mesh.complex()))
                continue;
            const auto dual = spectrum({{mesh.complex(), stars}, Side::dual, mesh.dimension() - k},
                                       {.count = count});
            EXPECT_EQ(number_enclosed(dual, exact), count) << name(kind) << ", k = " << k;
            for (Index i = 0; i < count; ++i) {
                const Vector x = found.modes.col(i), y = stars[k].solve(dual.modes.col(i));
                EXPECT_NEAR(x.dot(stars[k] * x), 1, 1e-9) << name(kind) << ", k = " << k;
                EXPECT_NEAR(y.dot(stars[k] * y), 1, 1e-9) << name(kind) << ", k = " << k;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Family, SpectraOfStars, testing::ValuesIn(names_of_meshes()),
                         parameter_name);

TEST(SpectraByStars, of_other_stars_lie_outside_of_the_radii) {
    const auto mesh = circumcentric(mesh_named("torus8x6"), {.criterion = MergeCriterion::none});
    const auto exact =
        extended_eigenvalues(mesh.complex(), mesh.with_stars(StarKind::galerkin).stars(), 1);
    const auto other = spectrum(
        {{mesh.complex(), mesh.with_stars(StarKind::barycentric).stars()}, Side::primal, 1},
        {.count = 6});
    EXPECT_LE(number_enclosed(other, exact), 2); // harmonic ones are 0 with all stars
}

/// One triangle has no free vertex, and its diagonal the only free edge of a square.
TEST(SpectraByStars, exist_where_no_cell_below_is_free) {
    const auto square = discretize(grid(1, 1), {.criterion = MergeCriterion::none});
    ASSERT_FALSE(square.stars()[0].is_diagonal() && square.stars()[1].is_diagonal());
    const FormSpace within(square, Side::primal, 1, BoundaryCondition::essential);
    ASSERT_EQ(within.size(), 1);
    const double stiffness = SparseMatrix(within.stiffness()).coeff(0, 0),
                 mass = within.inside().stars()[1].matrix().coeff(0, 0);
    EXPECT_NEAR(spectrum(within, {.count = 1}).eigenvalues[0], stiffness / mass, 1e-9 * stiffness);
    Mesh triangle = grid(1, 1);
    triangle.simplices = triangle.simplices.topRows(1).eval();
    const FormSpace dual(discretize(triangle), Side::dual, 0, BoundaryCondition::natural);
    EXPECT_EQ(spectrum(dual, {.count = 1}).eigenvalues[0], 0);
}

/// Shifts about every eigenvalue, near and far: the larger matrix counts what is below.
TEST(SpectraByStars, count_by_the_inertia_of_a_larger_matrix) {
    for (const char* title : {"ring6", "solid_torus3", "kuhn3", "star_negative"}) {
        const auto mesh = circumcentric(mesh_named(title), {.criterion = MergeCriterion::none});
        const auto stars = mesh.with_stars(StarKind::galerkin).stars();
        for (int k = 1; k < mesh.dimension(); ++k) {
            const Vector values = extended_eigenvalues(mesh.complex(), stars, k).cast<double>();
            const ScaledPencil pencil(laplacian_pencil(mesh.complex(), stars, k));
            ASSERT_EQ(pencil.matrices().hidden, mesh.complex().size(k - 1));
            const double unit = pencil.eigenvalue(1);
            InertiaCounter counter(pencil.matrices(), "auto", mesh.dimension(), pencil.doubt());
            auto wrong = pencil.matrices();
            wrong.hidden -= 1;
            InertiaCounter off_by_one(wrong, "auto", mesh.dimension(), pencil.doubt());
            const Index step = std::max<Index>(1, static_cast<Index>(values.size()) / 12);
            for (Index i = 1; i < values.size(); i += step) {
                const double gap = values[i] - values[i - 1];
                if (gap < 1e-6 * values[i])
                    continue;
                for (const double place : {1e-3, 0.5, 1 - 1e-3}) {
                    const double shift = values[i - 1] + place * gap;
                    const double distance = std::min(place, 1 - place) * gap;
                    EXPECT_EQ(counter.below(shift / unit, distance / unit), i)
                        << title << ", k = " << k << ", " << shift;
                    EXPECT_NE(off_by_one.below(shift / unit, distance / unit), i);
                }
            }
        }
    }
}

/// curl curl on a cube within perfectly conducting walls: pi^2 {2, 2, 2, 3, 3, 5}, in tets that no
/// diagonal star exists for.
TEST(SpectraByStars, of_a_cavity_converge) {
    const Vector exact = (Vector(6) << 2, 2, 2, 3, 3, 5).finished();
    const auto errors = [&](Index cells) {
        const auto mesh = circumcentric(shaken(kuhn(3, cells), 0.15, 3));
        const auto chosen = mesh.with_stars(StarKind::automatic).chosen_stars();
        EXPECT_EQ(chosen.kind, StarKind::galerkin);
        BoundaryConditions walls;
        walls.everywhere = BoundaryCondition::essential;
        const auto found = coexact_spectrum(
            {{mesh.complex(), chosen.stars}, Side::primal, 1, walls}, {.count = 6});
        const Vector values = found.eigenvalues / (std::numbers::pi * std::numbers::pi);
        return Vector((values - exact).cwiseQuotient(exact));
    };
    const double coarse = errors(3).norm(), fine = errors(6).norm();
    EXPECT_LT(fine, 0.1);
    EXPECT_GT(std::log2(coarse / fine), 1.5) << coarse << ' ' << fine;
}

TEST(SpectraByStars, refuse_masses_that_are_not_positive_definite) {
    const auto mesh = circumcentric(mesh_named("ring6"));
    SparseMatrix M = mesh.with_stars(StarKind::galerkin).stars()[1].matrix();
    M.coeffRef(0, 0) *= 0.1;
    const auto stars = mesh.stars().with(1, M);
    for (const int k : {0, 1, 2})
        EXPECT_REFUSED(spectrum({{mesh.complex(), stars}, Side::primal, k}, {.count = 2}),
                       "not positive definite")
            << k;
}

TEST(ModesOfDualForms, have_norm_1_where_no_flow_leaves_and_stars_are_matrices) {
    const auto mesh = discretize(mesh_named("obtuse_planar"), {.star = StarKind::galerkin});
    for (const int degree : {1, 2}) {
        const auto found =
            spectrum({mesh, Side::dual, degree, {BoundaryCondition::natural}}, {.count = 4});
        for (Index i = 0; i < found.modes.cols(); ++i)
            EXPECT_NEAR(norm(mesh, {Side::dual, degree, found.modes.col(i)}), 1, 1e-9) << degree;
    }
}

} // namespace polydec::test::in_spectra_of_stars
