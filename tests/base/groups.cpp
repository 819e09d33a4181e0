// SPDX-License-Identifier: MIT
#include "base/groups.h"

#include "tests/support/test.h"

namespace polydec::test::in_groups {

std::vector<Index> members(const Groups& groups, Index key) {
    return {groups[key].begin(), groups[key].end()};
}

TEST(Groups, have_ascending_members_and_leave_out_negative_keys) {
    const std::vector<Index> keys{2, 0, -1, 2, 0, -1, 2};
    const Groups groups(7, 4, [&](Index i) { return keys[i]; });
    EXPECT_EQ(members(groups, 0), (std::vector<Index>{1, 4}));
    EXPECT_EQ(members(groups, 1), (std::vector<Index>{}));
    EXPECT_EQ(members(groups, 2), (std::vector<Index>{0, 3, 6}));
    EXPECT_EQ(members(groups, 3), (std::vector<Index>{}));
}

} // namespace polydec::test::in_groups
