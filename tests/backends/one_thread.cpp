// SPDX-License-Identifier: MIT
#include "backends/linear/one_thread.h"

#include "tests/support/test.h"

namespace polydec::test::in_one_thread {

int level_limit() {
    const auto get = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, "omp_get_max_active_levels"));
    return get ? get() : 1;
}

TEST(OneThread, is_one_for_openmp_too_and_what_was_comes_back) {
    const int before = level_limit();
    {
        const OneThread one;
        EXPECT_EQ(level_limit(), dlsym(RTLD_DEFAULT, "omp_get_max_active_levels") ? 0 : 1);
    }
    EXPECT_EQ(level_limit(), before);
}

} // namespace polydec::test::in_one_thread
