// SPDX-License-Identifier: MIT
#include "dec/metric/dual_parts.h"
#include "tests/support/test.h"

namespace polydec::test::in_cochain {

class Cochains : public OverMeshes {
protected:
    /// A random form or chain of K or P.
    template <class Values>
    Values random(const CellComplex& complex, Side side, int degree, unsigned seed) const {
        const Index size = complex.size(cell_degree(complex, side, degree));
        return {side, degree, random_vector(size, seed)};
    }
};

constexpr double rounding = 1e-11;
constexpr Side sides[] = {Side::primal, Side::dual};

TEST_P(Cochains, stokes_theorem_pairs_d_with_the_boundary) {
    for (const auto& m : both(mesh()))
        for (const Side side : sides)
            for (int k = 0; k < mesh().n(); ++k) {
                const auto w = random<Cochain>(m.complex, side, k, 1);
                const auto c = random<Chain>(m.complex, side, k + 1, 2);
                const double left = pairing(d(m.complex, w), c);
                const double right = pairing(w, boundary(m.complex, c));
                const double size = d(m.complex, w).values.norm() * c.values.norm();
                EXPECT_NEAR(left, right, rounding * size) << m.name << ", k = " << k;
                if (std::abs(left) > 1e-3 * size) {
                    EXPECT_GT(std::abs(left + right), rounding * size) << "with the sign flipped";
                }
            }
}

TEST_P(Cochains, boundary_of_a_boundary_is_zero) {
    for (const auto& m : both(mesh()))
        for (const Side side : sides)
            for (int k = 2; k <= mesh().n(); ++k) {
                const auto c = random<Chain>(m.complex, side, k, 3);
                const auto twice = boundary(m.complex, boundary(m.complex, c));
                EXPECT_EQ(twice.degree, k - 2);
                EXPECT_LE(twice.values.cwiseAbs().maxCoeff(), 1e-13 * c.values.size());
            }
}

TEST_P(Cochains, star_star_is_the_sign_of_the_degree) {
    const int n = mesh().n();
    for (const auto& m : both(mesh()))
        for (const Side side : sides)
            for (int k = 0; k <= n; ++k) {
                const int cells = cell_degree(m.complex, side, k);
                if (!star(m.volumes, cells).zeros().empty())
                    continue;
                const auto w = random<Cochain>(m.complex, side, k, 4);
                const auto there = star({m.complex, m.volumes}, w);
                EXPECT_NE(there.side, side);
                EXPECT_EQ(there.degree, n - k);
                const double sign = k * (n - k) % 2 == 0 ? 1 : -1;
                const auto back = star({m.complex, m.volumes}, there);
                EXPECT_CLOSE(back.values, sign * w.values, rounding);
                EXPECT_GT(relative_difference(back.values, -sign * w.values), 1);
            }
}

TEST_P(Cochains, d_and_codifferential_are_adjoint) {
    for (const auto& m : both(mesh()))
        for (const Side side : sides)
            for (int k = 0; k < mesh().n(); ++k) {
                const int cells = cell_degree(m.complex, side, k);
                const int upper = cell_degree(m.complex, side, k + 1);
                if (!star(m.volumes, cells).zeros().empty() ||
                    !star(m.volumes, upper).zeros().empty())
                    continue;
                const auto a = random<Cochain>(m.complex, side, k, 5);
                const auto b = random<Cochain>(m.complex, side, k + 1, 6);
                const auto db = codifferential({m.complex, m.volumes}, b);
                const SparseMatrix c = side == Side::primal
                                           ? codifferential({m.complex, m.volumes}, k + 1)
                                           : dual_codifferential({m.complex, m.volumes}, k + 1);
                EXPECT_CLOSE(db.values, Vector(c * b.values), rounding);
                const double left = inner_product({m.complex, m.volumes}, d(m.complex, a), b);
                const double right = inner_product({m.complex, m.volumes}, a, db);
                const Vector mass = side == Side::primal ? star(m.volumes, upper).diagonal()
                                                         : star(m.volumes, upper).inverse();
                const double size =
                    d(m.complex, a).values.cwiseAbs().dot(mass.cwiseProduct(b.values).cwiseAbs());
                EXPECT_NEAR(left, right, rounding * size) << m.name << ", " << name(side) << k;
                if (std::abs(left) > 1e-3 * size) {
                    EXPECT_GT(std::abs(left + right), rounding * size) << "with the sign flipped";
                }
            }
}

TEST_P(Cochains, have_the_laplacian_of_the_operators) {
    const int n = mesh().n();
    for (const auto& m : both(mesh())) {
        bool invertible = true;
        for (int k = 0; k <= n; ++k)
            invertible = invertible && star(m.volumes, k).zeros().empty();
        if (!invertible)
            continue;
        for (const Side side : sides)
            for (int k = 0; k <= n; ++k) {
                const auto w = random<Cochain>(m.complex, side, k, 7);
                const SparseMatrix L = side == Side::primal
                                           ? laplacian({m.complex, m.volumes}, k)
                                           : dual_laplacian({m.complex, m.volumes}, k);
                EXPECT_CLOSE(laplacian({m.complex, m.volumes}, w).values, Vector(L * w.values),
                             rounding);
            }
    }
}

TEST_P(Cochains, the_star_is_an_isometry_where_duals_are_positive) {
    for (const auto& m : both(mesh()))
        for (int k = 0; k <= mesh().n(); ++k) {
            if (!star(m.volumes, k).zeros().empty() || !star(m.volumes, k).negatives().empty())
                continue;
            const auto w = random<Cochain>(m.complex, Side::primal, k, 8);
            const double length = norm({m.complex, m.volumes}, w);
            EXPECT_NEAR(norm({m.complex, m.volumes}, star({m.complex, m.volumes}, w)), length,
                        rounding * length);
        }
}

TEST_P(Cochains, parts_of_duals_sum_to_the_duals_and_weighted_to_the_simplices) {
    const auto& K = mesh().K();
    const int n = mesh().n();
    for (int m = 0; m <= n; ++m) {
        double binomial = 1; // m over k
        for (int k = 0; k <= m; ++k) {
            const SparseMatrix parts = dual_parts(mesh().geometry(), {}, k, m);
            const Vector rows = parts * mesh().input_volumes.primal(k);
            const double scale = parts.cwiseAbs().sum();
            EXPECT_WITHIN(rows, binomial * mesh().input_volumes.primal(m),
                          rounding * (scale + 1) * mesh().input_volumes.primal(k).maxCoeff());
            binomial *= double(m - k) / (k + 1);
            if (m == n) {
                const Vector columns = SparseMatrix(parts.transpose()) * Vector::Ones(K.size(n));
                EXPECT_WITHIN(columns, mesh().input_volumes.dual(k), rounding * scale)
                    << "k = " << k;
            }
        }
    }
}

POLYDEC_OVER_MESHES(Cochains);

TEST(CochainErrors, name_side_degree_and_sizes) {
    const auto& m = merged("grid4");
    const auto& P = m.P();
    EXPECT_REFUSED(d(P, {Side::primal, 1, Vector::Zero(3)}), "primal 1-form", "3 values",
                   "40 1-cells");
    EXPECT_REFUSED(d(P, {Side::dual, 0, Vector::Zero(25)}), "dual 0-form", "25 values",
                   "16 2-cells");
    EXPECT_REFUSED(star({P, m.volumes}, Cochain{Side::dual, 3, {}}), "dual forms", "degree 3",
                   "dimension 2", "0", "2");
    EXPECT_REFUSED(dual_derivative(P, 7), "dual forms of degree 7", "-1 to 2");
    EXPECT_EQ(dual_derivative(P, -1).cols(), 0);
    EXPECT_REFUSED(pairing({Side::primal, 1, Vector::Zero(40)}, {Side::dual, 1, Vector::Zero(40)}),
                   "dual 1-chain", "40 values", "primal 1-form", "40 values");
    const Cochain vertices{Side::primal, 0, Vector::Zero(25)},
        faces{Side::primal, 2, Vector::Zero(16)};
    EXPECT_REFUSED(vertices + faces, "primal 2-form", "16 values", "primal 0-form", "25 values");
    const auto& bad = merged("star_negative");
    Vector spike = Vector::Zero(bad.P().size(0));
    spike[star(bad.volumes, 0).negatives().front()] = 1;
    EXPECT_REFUSED(norm({bad.P(), bad.volumes}, {Side::primal, 0, spike}), "norm", "primal 0-form",
                   "7 values");
}

TEST(Norms, are_in_range_where_their_squares_are_not) {
    const auto& m = merged("grid4");
    const auto some_form = [&](Side side, int k) {
        return Cochain{side, k, random_vector(m.P().size(cell_degree(m.P(), side, k)), 3)};
    };
    const Cells cells(m.P(), m.volumes);
    for (const int k : {0, 1, 2})
        for (const Side side : sides) {
            const auto w = some_form(side, k);
            for (const int exponent : {-900, -600, 600, 900})
                EXPECT_EQ(norm(cells, std::exp2(exponent) * w),
                          std::exp2(exponent) * norm(cells, w));
            EXPECT_REFUSED(inner_product(cells, 0x1p600 * w, 0x1p600 * w), "inner product",
                           "range");
            EXPECT_EQ(inner_product(cells, 0x1p-600 * w, 0x1p-600 * w), 0);
            EXPECT_EQ(norm(cells, 0 * w), 0);
        }
    // in a unit that the norm leaves the range by
    const Cells huge(m.P(), HodgeStars(m.volumes), 0x1p1022);
    EXPECT_REFUSED(norm(huge, 16 * some_form(Side::primal, 0)), "norm", "range");
    EXPECT_GT(norm(huge, some_form(Side::primal, 1)), 0);
}

TEST(CochainErrors, name_the_value_that_is_no_number) {
    const auto& m = merged("grid4");
    for (const double value : {NAN, INFINITY, -INFINITY}) {
        const Cochain zero{Side::primal, 1, Vector::Zero(40)};
        Cochain bad = zero;
        bad.values[7] = value;
        const std::string wrong = std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
        const Words form{"primal 1-form", "40 values", "7", wrong};
        const Words of_chain{"primal 1-chain", "40 values", "7", wrong};
        const Chain chain{Side::primal, 1, Vector::Zero(40)},
            bad_chain{Side::primal, 1, bad.values};
        EXPECT_REFUSED(d(m.P(), bad), form);
        EXPECT_REFUSED(boundary(m.P(), bad_chain), of_chain);
        EXPECT_REFUSED(pairing(zero, bad_chain), of_chain);
        EXPECT_REFUSED(pairing(bad, chain), form);
        EXPECT_REFUSED(zero + bad, form);
        EXPECT_REFUSED(inner_product({m.P(), m.volumes}, zero, bad), form);
        EXPECT_NO_THROW(d(m.P(), zero) + d(m.P(), zero));
    }
}

TEST(Cochains, of_the_ends_of_the_tower_are_empty) {
    const auto& P = merged("grid4").P();
    EXPECT_EQ(d(P, {Side::primal, 2, Vector::Zero(16)}).values.size(), 0);
    EXPECT_EQ(boundary(P, {Side::dual, 0, Vector::Zero(16)}).values.size(), 0);
    EXPECT_EQ(boundary(P, {Side::primal, 0, Vector::Zero(25)}).degree, -1);
}

} // namespace polydec::test::in_cochain
