// SPDX-License-Identifier: MIT
#include "system/control_group.h"
#include "tests/support/test.h"

namespace polydec::test::in_memory {

namespace fs = std::filesystem;

std::string refusal(double bytes) {
    return message_of<IoError>([&] { check_memory(bytes, "a thing"); });
}

TEST(MemoryLimit, is_the_least_of_the_control_groups_around_the_process) {
    std::string name = (fs::temp_directory_path() / "groups-XXXXXX").string();
    const fs::path folder = ::mkdtemp(name.data());
    const auto write = [&](const fs::path& path, const char* text) {
        fs::create_directories((folder / path).parent_path());
        std::ofstream(folder / path) << text;
    };
    const auto limit_of = [&](const char* groups) {
        write("groups", groups);
        return control_group_memory(folder / "groups", folder);
    };
    constexpr auto unlimited = std::numeric_limits<std::uint64_t>::max();
    EXPECT_EQ(limit_of("0::/user.slice/job\n"), unlimited);
    EXPECT_EQ(control_group_memory(folder / "none", folder), unlimited);
    write("memory.max", "5000\n");
    write("user.slice/memory.max", "3000\n");
    write("user.slice/a:b/memory.max", "max\n");
    write("user.slice/a:b/inner/memory.max", "4000\n");
    write("other/memory.max", "1\n");
    EXPECT_EQ(control_group_memory(folder / "none", folder), 5000);
    EXPECT_EQ(limit_of("0::/\n"), 5000);
    EXPECT_EQ(limit_of("0::/user.slice/a:b/inner\n"), 3000);
    EXPECT_EQ(limit_of("0::/not/below/the/mount\n"), 5000);
    EXPECT_EQ(limit_of("0::/../user.slice\nnonsense\n"), 3000);
    write("memory/job/memory.limit_in_bytes", "2000\n");
    write("memory/other/memory.limit_in_bytes", "1\n");
    EXPECT_EQ(limit_of("9:cpu,memory:/job/step\n3:cpuset:/other\n1:memory_like:/other\n"), 2000);
    fs::remove_all(folder);
}

TEST(MemoryLimit, is_the_machines_at_first) {
    EXPECT_GT(machine_memory(), 1U << 20U);
    EXPECT_EQ(memory_limit(), machine_memory());
}

TEST(MemoryLimit, refuses_what_is_above_it) {
    set_memory_limit(2000000);
    EXPECT_EQ(refusal(2e6), "accepted");
    EXPECT_SAYS(refusal(3e6), "3 MB", "memory", "2 MB");
    for (const double bytes :
         {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN(), 1e300})
        EXPECT_NE(refusal(bytes), "accepted");
    set_memory_limit(machine_memory());
    EXPECT_EQ(refusal(3e6), "accepted");
}

} // namespace polydec::test::in_memory
