// SPDX-License-Identifier: MIT
#include "tests/backends/matrices.h"

namespace polydec::test::in_cholmod {

TEST(cholmod, factors_of_both_kinds_are_held_against_memory_before_they_are_made) {
    const SparseMatrix A = grid_laplacian(100);
    for (const auto& facts : {positive(), indefinite()}) {
        const auto solver = make_linear_solver("cholmod");
        set_memory_limit(1000000);
        const auto told = message_of<OutOfMemory>([&] { solver->factorize(A, facts); });
        set_memory_limit(machine_memory());
        EXPECT_SAYS(told, "cholmod", "10000 x 10000", "1 MB", "iterative");
        EXPECT_NO_THROW(solver->factorize(A, facts));
    }
}

} // namespace polydec::test::in_cholmod
