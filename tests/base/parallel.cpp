// SPDX-License-Identifier: MIT
#include "base/parallel.h"

#include "tests/support/test.h"

namespace polydec::test::in_parallel {

TEST(parallel, parts_make_up_the_whole_once) {
    for (const Index count : {0, 1, 6, 7, 8, 1000})
        for (const Index size : {1, 7, 1000, 5000}) {
            std::vector<int> visits(static_cast<std::size_t>(count), 0);
            for_each_part(count, size, [&](Index begin, Index end) {
                EXPECT_EQ(begin % size, 0);
                EXPECT_EQ(end, std::min(begin + size, count));
                for (Index i = begin; i < end; ++i)
                    ++visits[static_cast<std::size_t>(i)];
            });
            EXPECT_EQ(visits, std::vector<int>(static_cast<std::size_t>(count), 1));
        }
}

TEST(parallel, the_exception_of_the_first_part_is_passed_on_when_all_have_ended) {
    std::vector<int> visits(100, 0);
    std::string message;
    try {
        for_each_part(100, 10, [&](Index begin, Index end) {
            for (Index i = begin; i < end; ++i)
                ++visits[static_cast<std::size_t>(i)];
            if (begin >= 30)
                throw std::runtime_error(std::to_string(begin));
        });
    } catch (const std::runtime_error& error) {
        message = error.what();
    }
    EXPECT_EQ(message, "30");
    EXPECT_EQ(visits, std::vector<int>(100, 1));
}

TEST(parallel, parts_may_have_parts) {
    std::vector<int> visits(1000, 0);
    for_each_part(10, 1, [&](Index i, Index) {
        for_each_part(100, 10, [&](Index begin, Index end) {
            for (Index j = begin; j < end; ++j)
                ++visits[static_cast<std::size_t>(100 * i + j)];
        });
    });
    EXPECT_EQ(visits, std::vector<int>(1000, 1));
}

} // namespace polydec::test::in_parallel
