// SPDX-License-Identifier: MIT
#include "backends/linear/engine_threads.h"

#include "tests/support/test.h"

namespace polydec::test::in_engine_threads {

int level_limit() {
    const auto get = reinterpret_cast<int (*)()>(dlsym(RTLD_DEFAULT, "omp_get_max_active_levels"));
    return get ? get() : 1;
}

TEST(EngineThreads, one_is_one_for_openmp_too_and_what_was_comes_back) {
    const int before = level_limit();
    {
        const EngineThreads one(1);
        EXPECT_EQ(level_limit(), dlsym(RTLD_DEFAULT, "omp_get_max_active_levels") ? 0 : 1);
    }
    EXPECT_EQ(level_limit(), before);
    for (const int wished : {0, 2}) {
        const EngineThreads other(wished);
        EXPECT_EQ(level_limit(), before) << wished;
    }
}

} // namespace polydec::test::in_engine_threads
