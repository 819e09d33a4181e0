// SPDX-License-Identifier: MIT
#include "complex/size_estimate.h"

#include "tests/support/test.h"

namespace polydec::test::in_size_estimate {

SizeEstimate size_of(const SimplicialComplex& complex) {
    SizeEstimate size;
    for (int k = 0; k <= complex.dimension(); ++k) {
        size.cells += complex.size(k);
        size.incidences += k > 0 ? (k + 1.0) * complex.size(k) : 0;
    }
    return size;
}

/// Disjoint n-simplices.
Simplices apart(int n, Index count) {
    Simplices tops(count, n + 1);
    for (Index i = 0; i < count; ++i)
        for (int j = 0; j <= n; ++j)
            tops(i, j) = i * (n + 1) + j;
    return tops;
}

TEST(SizeEstimate, is_exact_for_simplices_that_meet_nowhere) {
    for (int n = 1; n <= 10; ++n)
        for (const Index count : {1, 3}) {
            const auto size = size_of(SimplicialComplex(apart(n, count)));
            const auto guess = estimate_size(n, count, count * (n + 1));
            EXPECT_NEAR(guess.cells, size.cells, 1e-9 * size.cells);
            EXPECT_NEAR(guess.incidences, size.incidences, 1e-9 * size.incidences);
        }
}

TEST(SizeEstimate, of_grids_is_between_half_and_all) {
    for (const auto& mesh : {kuhn({50}), grid(20, 20), icosphere(10), kuhn({6, 6, 6}),
                             fcc({4, 4, 4}, 1.0), kuhn({3, 3, 3, 3}), kuhn({2, 2, 2, 2, 2})}) {
        const SimplicialComplex complex(mesh.simplices);
        const auto n = complex.dimension();
        const auto size = size_of(complex),
                   guess = estimate_size(n, complex.size(n), complex.size(0));
        EXPECT_LE(guess.cells, 1.1 * size.cells) << n;
        EXPECT_GE(guess.cells, 0.5 * size.cells) << n;
        EXPECT_LE(guess.incidences, 1.1 * size.incidences) << n;
        EXPECT_GE(guess.incidences, 0.5 * size.incidences) << n;
    }
}

TEST(SizeEstimate, grows_beyond_every_memory_without_overflow) {
    EXPECT_GT(estimate_size(60, 1, 61).bytes(), 1e18);
    EXPECT_TRUE(std::isinf(estimate_size(2000, 1, 2001).bytes()));
}

TEST(SizeEstimate, is_looked_at_before_a_complex_is_built) {
    set_memory_limit(100000000);
    EXPECT_NO_THROW(SimplicialComplex(apart(12, 1)));
    EXPECT_THROW(SimplicialComplex(apart(20, 1)), IoError);
    EXPECT_THROW(SimplicialComplex(apart(28, 1)), IoError);
    set_memory_limit(machine_memory());
}

} // namespace polydec::test::in_size_estimate
