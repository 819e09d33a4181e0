// SPDX-License-Identifier: MIT
#include "shape/count_below.h"
#include "tests/shape/known_shapes.h"
#include "tests/support/refusal.h"
#include "tests/support/says.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

namespace polydec::test::in_counts {
namespace {

/// How many random shapes the law is tried on; POLYDEC_SHAPES sets another number.
int tries() {
    const char* given = std::getenv("POLYDEC_SHAPES");
    return given == nullptr ? 120 : std::max(1, std::atoi(given));
}

Index below(const std::vector<double>& eigenvalues, double s) {
    return static_cast<Index>(std::count_if(eigenvalues.begin(), eigenvalues.end(),
                                            [s](double value) { return value < s; }));
}

/// The law of it all: at least low(s), at most high(s).
TEST(CountBelow, encloses_the_number_of_eigenvalues) {
    std::mt19937 random(1);
    Index counts = 0, exact = 0;
    for (int i = 0; i < tries(); ++i) {
        const KnownShape known = random_shape(random);
        for (int j = 0; j < 5; ++j) {
            const double s = 150 * std::pow(random() / 4294967296.0, 2);
            for (const int degree : {1, 2}) {
                const auto count = count_below(known.shape, s, {.degree = degree});
                const Index truth = below(known.eigenvalues, s);
                EXPECT_LE(count.at_least, truth) << known.name << i << " " << s << " " << degree;
                if (!count.at_most)
                    continue;
                EXPECT_GE(*count.at_most, truth) << known.name << i << " " << s << " " << degree;
                ++counts;
                exact += count.at_least == *count.at_most;
            }
        }
    }
    EXPECT_GE(counts, tries() * 3);
    EXPECT_GE(2 * exact, counts); // it says something
    RecordProperty("counts", counts);
    RecordProperty("exact", exact);
}

} // namespace
} // namespace polydec::test::in_counts
