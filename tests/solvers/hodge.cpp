// SPDX-License-Identifier: MIT
#include "tests/solvers/star_samples.h"

namespace polydec::test::in_hodge {

constexpr double rounding = 1e-10;

/// The same values, but for rounding of numbers of the size of others.
void expect_same(const Vector& values, const Vector& expected, const Vector& others) {
    EXPECT_LE((values - expected).norm(), rounding * others.norm());
}

/// With nothing fixed, so that stars without entries of 0 are all that is needed.
FormSpace all_forms(const Cells& cells, Side side, int degree) {
    return FormSpace::vanishing_on(cells, side, degree);
}

/// On any cells, by any positive star of k-cells: parts of forms of both sides add up, are
/// orthogonal, and have their potentials.
void expect_orthogonal_parts(const CellComplex& complex, const HodgeStars& stars, int k) {
    const int n = complex.dimension();
    for (const Side side : {Side::primal, Side::dual}) {
        const int degree = side == Side::primal ? k : n - k;
        SCOPED_TRACE(name(side));
        const Cochain w{side, degree, random_vector(complex.size(k), 1)};
        const auto parts = hodge_decomposition(all_forms({complex, stars}, w.side, w.degree), w);
        const double square = inner_product({complex, stars}, w, w);
        const auto product = [&](const Cochain& a, const Cochain& b) {
            return std::abs(inner_product({complex, stars}, a, b)) / square;
        };
        EXPECT_LE(product(parts.exact, parts.coexact), rounding);
        EXPECT_LE(product(parts.exact, parts.harmonic), rounding);
        EXPECT_LE(product(parts.coexact, parts.harmonic), rounding);
        expect_same((parts.exact + parts.coexact + parts.harmonic).values, w.values, w.values);
        if (degree > 0)
            expect_same(d(complex, parts.potential).values, parts.exact.values, w.values);
        if (degree < n)
            expect_same(d(complex, parts.copotential).values,
                        star({complex, stars}, parts.coexact).values,
                        star({complex, stars}, w).values);
    }
}

/// Harmonic forms are as many as Betti numbers say, orthonormal, closed, coclosed, and stay.
void expect_harmonic_forms(const CellComplex& complex, const HodgeStars& stars, int k) {
    const int n = complex.dimension();
    const HodgeSolver solver(all_forms({complex, stars}, Side::primal, k));
    const DenseMatrix H = solver.harmonic_forms();
    ASSERT_EQ(H.cols(), betti_numbers(complex)[k]);
    EXPECT_EQ(harmonic_forms(all_forms({complex, stars}, Side::dual, n - k)).cols(), H.cols());
    const DenseMatrix masses = stars[k].matrix() * H;
    EXPECT_LE((H.transpose() * masses - DenseMatrix::Identity(H.cols(), H.cols())).norm(),
              rounding * static_cast<double>(H.cols()));
    for (Index i = 0; i < H.cols(); ++i) {
        const Vector form = H.col(i), mass = masses.col(i);
        EXPECT_LE((derivative(complex, k - 1).transpose() * mass).norm(), rounding * mass.norm());
        EXPECT_LE((derivative(complex, k) * form).norm(), rounding * form.norm());
        expect_same(solver.decompose({Side::primal, k, form}).harmonic.values, form, form);
    }
}

/// Exact forms have no other part, nor have coexact ones.
void expect_parts_stay(const CellComplex& complex, const HodgeStars& stars, int k) {
    const HodgeSolver solver(all_forms({complex, stars}, Side::primal, k));
    if (k > 0) {
        const Vector da = derivative(complex, k - 1) * random_vector(complex.size(k - 1), 2);
        expect_same(solver.decompose({Side::primal, k, da}).exact.values, da, da);
    }
    if (k < complex.dimension()) {
        const Vector delta =
            codifferential({complex, stars}, k + 1) * random_vector(complex.size(k + 1), 3);
        expect_same(solver.decompose({Side::primal, k, delta}).coexact.values, delta, delta);
    }
}

bool positive(const CellVolumes& volumes, int k) {
    return star(volumes, k).zeros().empty() && star(volumes, k).negatives().empty();
}

class HodgeParted : public OverMeshes {
protected:
    /// Calls law(complex, volumes, k) for K, P and P relative to its boundary and every degree
    /// whose star is positive.
    template <class Law>
    void for_positive(Law law) const {
        for (const auto& m : both(mesh()))
            for (int k = 0; k <= mesh().n(); ++k)
                if (positive(m.volumes, k)) {
                    SCOPED_TRACE("k = " + std::to_string(k));
                    law(m.complex, m.volumes, k);
                }
        const auto relative = relative_to_boundary(mesh().P());
        const auto volumes = relative_volumes(relative, mesh().volumes);
        for (int k = 0; k <= mesh().n(); ++k)
            if (relative.complex.size(k) > 0 && positive(volumes, k)) {
                SCOPED_TRACE("relative to the boundary, k = " + std::to_string(k));
                law(relative.complex, volumes, k);
            }
    }

    /// Also with stars of every kind for cells and simplices, relative to the boundary too, and for
    /// surfaces after flips.
    template <class Law>
    void for_all(Law law) const {
        for_positive(law);
        for (const auto& [title, mesh, chosen] : with_star_kinds(GetParam())) {
            const auto relative = relative_to_boundary(mesh.complex());
            const HodgeStars restricted = relative_stars(relative, mesh.stars());
            for (int k = 0; k <= mesh.dimension(); ++k) {
                SCOPED_TRACE(title + ", k = " + std::to_string(k));
                law(mesh.complex(), mesh.stars(), k);
                if (relative.complex.size(k) > 0 &&
                    relative.complex.size(k) < mesh.complex().size(k)) {
                    SCOPED_TRACE("relative to the boundary");
                    law(relative.complex, restricted, k);
                }
            }
        }
        if (mesh().n() != 2 || branches(mesh().K()))
            return;
        const auto flipped = circumcentric(shaken(mesh_named(GetParam()), 0.25, 7),
                                           {.delaunay = Delaunay::flips_and_splits});
        for (int k = 0; k <= 2; ++k) {
            SCOPED_TRACE("after flips, k = " + std::to_string(k));
            law(flipped.complex(), flipped.volumes(), k);
        }
    }
};

TEST_P(HodgeParted, forms_are_sums_of_orthogonal_parts_with_their_potentials) {
    for_all(expect_orthogonal_parts);
}

TEST_P(HodgeParted, harmonic_forms_are_as_many_as_betti_numbers_say_closed_and_coclosed) {
    for_all(expect_harmonic_forms);
}

TEST_P(HodgeParted, exact_and_coexact_forms_have_no_other_part) {
    for_all(expect_parts_stay);
}

/// The volumes of the same cells measured in another unit.
CellVolumes in_other_units(const CellVolumes& volumes, double size) {
    std::vector<Vector> primal, dual;
    const int n = volumes.dimension();
    for (int k = 0; k <= n; ++k) {
        primal.emplace_back(std::pow(size, k) * volumes.primal(k));
        dual.emplace_back(std::pow(size, n - k) * volumes.dual(k));
    }
    return {std::move(primal), std::move(dual)};
}

TEST_P(HodgeParted, forms_of_meshes_of_every_size_have_the_same_parts) {
    const int n = mesh().n();
    if (n > 3)
        return;
    for_positive([&](const CellComplex& complex, const CellVolumes& volumes, int k) {
        for (const double size : {0x1p-300, 0x1p300})
            for (const Side side : {Side::primal, Side::dual}) {
                const int degree = side == Side::primal ? k : n - k;
                const Cochain w{side, degree, random_vector(complex.size(k), 1)};
                const auto here =
                    hodge_decomposition(all_forms({complex, volumes}, w.side, w.degree), w);
                const auto there = hodge_decomposition(
                    all_forms({complex, in_other_units(volumes, size)}, w.side, w.degree), w);
                const double star = std::pow(size, n - 2 * k);
                for (const auto part : {&HodgeParts::exact, &HodgeParts::coexact})
                    EXPECT_LE(((there.*part).values - (here.*part).values).norm(),
                              1e-9 * w.values.norm());
                const double factor = side == Side::primal ? star : 1 / star;
                const auto expect_equal = [](const Vector& found, const Vector& expected) {
                    EXPECT_LE((found - expected).norm(), 1e-8 * expected.norm());
                };
                expect_equal(there.potential.values, here.potential.values);
                expect_equal(there.copotential.values / factor, here.copotential.values);
                const auto before = harmonic_forms(all_forms({complex, volumes}, side, degree));
                const auto after = harmonic_forms(
                    all_forms({complex, in_other_units(volumes, size)}, side, degree));
                ASSERT_EQ(after.cols(), before.cols());
                const double root = std::pow(size, (side == Side::primal ? -1 : 1) * (n / 2.0 - k));
                if (before.size() > 0) {
                    EXPECT_LE((after / root - before).lpNorm<Eigen::Infinity>(),
                              1e-9 * before.lpNorm<Eigen::Infinity>());
                }
            }
    });
}

POLYDEC_OVER_MESHES(HodgeParted);

TEST(HodgeByOtherStars, parts_are_orthogonal_in_their_own_inner_product_alone) {
    const auto mesh = circumcentric(shaken(grid(6, 6), 0.42, 3));
    const auto stars = mesh.with_stars(StarKind::automatic).stars();
    const auto other = mesh.with_stars(StarKind::barycentric).stars();
    ASSERT_FALSE(stars[1].is_diagonal());
    const Cochain w{Side::primal, 1, random_vector(mesh.complex().size(1), 1)};
    const auto parts = hodge_decomposition({{mesh.complex(), stars}, w.side, w.degree}, w);
    EXPECT_GT(std::abs(inner_product({mesh.complex(), other}, parts.exact, parts.coexact)),
              1e-3 * inner_product({mesh.complex(), other}, w, w));
}

/// Stars of the same cells measured in another unit.
TEST(HodgeByOtherStars, parts_of_cells_of_every_size_are_the_same) {
    const auto mesh = circumcentric(shaken(kuhn(3, 2), 0.3, 3));
    const auto& complex = mesh.complex();
    const auto chosen = mesh.with_stars(StarKind::galerkin).stars();
    const Cochain w{Side::primal, 1, random_vector(complex.size(1), 1)};
    const auto here = hodge_decomposition(all_forms({complex, chosen}, w.side, w.degree), w);
    for (const double factor : {0x1p-300, 0x1p300}) {
        const auto stars = chosen.with(1, factor * chosen[1].matrix());
        const auto there = hodge_decomposition(all_forms({complex, stars}, w.side, w.degree), w);
        EXPECT_CLOSE(there.exact.values, here.exact.values, rounding);
        EXPECT_CLOSE(there.coexact.values, here.coexact.values, rounding);
        EXPECT_CLOSE(there.copotential.values / factor, here.copotential.values,
                     1e-6); // but for what d takes to 0
        EXPECT_EQ(harmonic_forms(all_forms({complex, stars}, Side::primal, 1)).cols(), 0);
    }
}

TEST(HodgeByOtherStars, refuse_a_matrix_that_is_not_definite) {
    const auto mesh = circumcentric(grid(2, 2));
    SparseMatrix M(mesh.complex().size(1), mesh.complex().size(1));
    M.setIdentity();
    M.coeffRef(0, 1) = M.coeffRef(1, 0) = 2;
    const auto stars = mesh.stars().with(1, M);
    EXPECT_REFUSED(HodgeSolver({{mesh.complex(), stars}, Side::primal, 1}), "negative eigenvalue");
}

TEST(MixedConditions, have_the_harmonic_forms_of_the_pair) {
    // a ring held at the outer circle is that circle times an interval held at one end
    const auto ring = circumcentric(annulus(12));
    const auto& P = ring.complex();
    const Points sites = cell_centers(ring, 1);
    const double middle =
        0.5 * (sites.rowwise().norm().maxCoeff() + sites.rowwise().norm().minCoeff());
    const auto held =
        relative_complex(P, essential_cells(P, essential_where(sites, [&](const Vector& site) {
                                                return site.norm() > middle;
                                            })));
    EXPECT_EQ(betti_numbers(held.complex), (std::vector<Index>{0, 0, 0}));
    const auto volumes = relative_volumes(held, ring.volumes());
    EXPECT_EQ(harmonic_forms({{held.complex, volumes}, Side::primal, 1}).cols(), 0);
}

TEST(HarmonicForms, on_a_flat_ring_are_the_angle) {
    // |d angle|^2 integrates to 2 pi log(outer / inner), so periods tell the norm
    const auto error = [](int segments) {
        const auto ring = circumcentric(annulus(segments));
        const DenseMatrix H = harmonic_forms({{ring.complex(), ring.volumes()}, Side::primal, 1});
        const SparseMatrix G = homology_generators(ring.complex(), 1);
        const double period = std::abs((G.transpose() * H)(0, 0));
        const double outer = ring.points().rowwise().norm().maxCoeff();
        const double inner = ring.points().rowwise().norm().minCoeff();
        const double exact = std::sqrt(2 * M_PI / std::log(outer / inner));
        return std::abs(period - exact) / exact;
    };
    EXPECT_LT(error(64), 0.1);
}

TEST(HodgeBroken, without_one_cell_of_the_minor_the_exact_part_is_not_all) {
    const auto& m = merged("torus8x6");
    auto columns = regular_minor(m.P(), 0).columns;
    columns.pop_back();
    const DenseMatrix D = DenseMatrix(derivative(m.P(), 0))(Eigen::indexing::all, columns);
    const Vector w = derivative(m.P(), 0) * random_vector(m.P().size(0), 5);
    const Vector mass = star(m.volumes, 1).diagonal();
    const DenseMatrix A = D.transpose() * mass.asDiagonal() * D;
    const Vector x = A.llt().solve(D.transpose() * mass.cwiseProduct(w));
    EXPECT_GT((D * x - w).norm(), 1e-3 * w.norm());
}

TEST(HodgeBroken, in_the_plain_inner_product_parts_are_not_orthogonal_in_the_star) {
    const auto& m = merged("torus9x5");
    CellVolumes ones = m.volumes;
    for (int k = 0; k <= 2; ++k)
        ones = ones.with_dual(k, ones.primal(k));
    const Cochain w{Side::primal, 1, random_vector(m.P().size(1), 6)};
    const auto parts = hodge_decomposition({{m.P(), ones}, w.side, w.degree}, w);
    EXPECT_GT(std::abs(inner_product({m.P(), m.volumes}, parts.exact, parts.coexact)),
              1e-4 * inner_product({m.P(), m.volumes}, w, w));
}

TEST(HodgeErrors, name_what_is_missing) {
    const auto& m = merged("fcc1");
    EXPECT_REFUSED(HodgeSolver({{m.P(), m.volumes}, Side::primal, 2}), "mass", "primal 2-forms",
                   "not positive", "24 of 56 2-cells");
    const auto& grid = merged("grid4");
    HodgeSolver solver({{grid.P(), grid.volumes}, Side::dual, 1});
    EXPECT_REFUSED(solver.decompose({Side::primal, 1, Vector::Zero(40)}), "primal 1-form",
                   "dual 1-form");
    Vector bad = Vector::Zero(40);
    bad[3] = NAN;
    EXPECT_REFUSED(solver.decompose({Side::dual, 1, bad}), "dual 1-form", "40 values", "3", "nan");
}

} // namespace polydec::test::in_hodge
