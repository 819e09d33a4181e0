// SPDX-License-Identifier: MIT
#include "base/memory.h"

#include "base/errors.h"

#include <gtest/gtest.h>

#include <limits>

namespace polydec {

namespace {

std::string refusal(double bytes) {
    try {
        check_memory(bytes, "a thing");
    } catch (const IoError& error) {
        return error.what();
    }
    return "";
}

} // namespace

TEST(MemoryLimit, is_the_machines_at_first) {
    EXPECT_GT(machine_memory(), 1U << 20U);
    EXPECT_EQ(memory_limit(), machine_memory());
}

TEST(MemoryLimit, refuses_what_is_above_it) {
    set_memory_limit(2000000);
    EXPECT_EQ(refusal(2e6), "");
    EXPECT_EQ(refusal(3e6), "a thing takes about 3 MB of memory, but only 2 MB may be used: take "
                            "fewer or simpler cells, or allow more (set_memory_limit)");
    for (const double bytes :
         {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN(), 1e300})
        EXPECT_NE(refusal(bytes), "");
    set_memory_limit(machine_memory());
    EXPECT_EQ(refusal(3e6), "");
}

} // namespace polydec
