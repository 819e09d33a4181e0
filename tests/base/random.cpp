// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test::in_random {

// The 10000th number of either engine with its usual seed: C++20, [rand.predef].
TEST(random, numbers_are_those_of_the_standard_on_every_machine) {
    Vector noise(10000);
    Noise(5489).fill(noise);
    EXPECT_EQ(noise[9999], 4123659995.0 / 4294967296.0 - 0.5);

    Random random(5489);
    for (int i = 1; i < 10000; ++i)
        random.fraction();
    EXPECT_EQ(random.fraction(), std::ldexp(static_cast<double>(9981545732273789042U >> 11U), -53));
}

TEST(random, columns_are_filled_one_behind_the_other) {
    DenseMatrix columns(7, 3);
    Noise(1).fill(columns.reshaped());
    Vector together(21);
    Noise(1).fill(together);
    EXPECT_EQ(Vector(columns.reshaped()), together);
    Noise(2).fill(together);
    EXPECT_NE(Vector(columns.reshaped()), together);
}

} // namespace polydec::test::in_random
