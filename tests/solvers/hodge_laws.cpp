// SPDX-License-Identifier: MIT
#include "tests/solvers/hodge_laws.h"

#include "complex/homology.h"
#include "dec/operators.h"
#include "solvers/hodge.h"
#include "tests/support/matrices.h"

#include <gtest/gtest.h>

#include <cmath>

namespace polydec::test {

namespace {

constexpr double rounding = 1e-10;

/// The same values, but for rounding of numbers of the size of others.
void expect_same(const Vector& values, const Vector& expected, const Vector& others) {
    EXPECT_LE((values - expected).norm(), rounding * others.norm());
}

} // namespace

void expect_orthogonal_parts(const CellComplex& complex, const HodgeStars& stars, int k) {
    const int n = complex.dimension();
    for (const Side side : {Side::primal, Side::dual}) {
        const int degree = side == Side::primal ? k : n - k;
        SCOPED_TRACE(name(side));
        const Cochain w{side, degree, random_vector(complex.size(k), 1)};
        const auto parts = hodge_decomposition(complex, stars, w);
        const double square = inner_product(complex, stars, w, w);
        const auto product = [&](const Cochain& a, const Cochain& b) {
            return std::abs(inner_product(complex, stars, a, b)) / square;
        };
        EXPECT_LE(product(parts.exact, parts.coexact), rounding);
        EXPECT_LE(product(parts.exact, parts.harmonic), rounding);
        EXPECT_LE(product(parts.coexact, parts.harmonic), rounding);
        expect_same((parts.exact + parts.coexact + parts.harmonic).values, w.values, w.values);
        if (degree > 0)
            expect_same(d(complex, parts.potential).values, parts.exact.values, w.values);
        if (degree < n)
            expect_same(d(complex, parts.copotential).values,
                        star(complex, stars, parts.coexact).values, star(complex, stars, w).values);
    }
}

void expect_harmonic_forms(const CellComplex& complex, const HodgeStars& stars, int k) {
    const int n = complex.dimension();
    const HodgeSolver solver(complex, stars, Side::primal, k);
    const DenseMatrix H = solver.harmonic_forms();
    ASSERT_EQ(H.cols(), betti_numbers(complex)[k]);
    EXPECT_EQ(harmonic_forms(complex, stars, Side::dual, n - k).cols(), H.cols());
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

void expect_parts_stay(const CellComplex& complex, const HodgeStars& stars, int k) {
    const HodgeSolver solver(complex, stars, Side::primal, k);
    if (k > 0) {
        const Vector da = derivative(complex, k - 1) * random_vector(complex.size(k - 1), 2);
        expect_same(solver.decompose({Side::primal, k, da}).exact.values, da, da);
    }
    if (k < complex.dimension()) {
        const Vector delta =
            codifferential(complex, stars, k + 1) * random_vector(complex.size(k + 1), 3);
        expect_same(solver.decompose({Side::primal, k, delta}).coexact.values, delta, delta);
    }
}

} // namespace polydec::test
