// SPDX-License-Identifier: MIT
#include "tests/io/support.h"

namespace polydec::test::in_checkpoint {

Checkpoint sample() {
    Checkpoint result{.problem = 7, .step = 12, .time = 0.1, .state = {}};
    result.state.push_back(Vector::LinSpaced(1000, -1, 1));
    result.state.push_back(Vector(0));
    result.state.push_back(Vector{{-0.0, std::numeric_limits<double>::denorm_min(), 1e300}});
    return result;
}

void write_bytes(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

TEST(Checkpoint, IsReadToTheSameBits) {
    const TemporaryFolder folder;
    const auto path = folder.path("a.checkpoint");
    const Checkpoint written = sample();
    write_checkpoint(path, written);
    const Checkpoint read = read_checkpoint(path, 7);
    EXPECT_EQ(read.step, 12U);
    EXPECT_EQ(read.time, 0.1);
    ASSERT_EQ(read.state.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_EQ(read.state[i].size(), written.state[i].size());
        for (Index j = 0; j < read.state[i].size(); ++j)
            EXPECT_EQ(std::bit_cast<std::uint64_t>(read.state[i][j]),
                      std::bit_cast<std::uint64_t>(written.state[i][j]));
    }
    EXPECT_EQ(folder.names(), std::vector<std::string>{"a.checkpoint"});
}

TEST(Checkpoint, OfAnotherProblemIsRefused) {
    const TemporaryFolder folder;
    const auto path = folder.path("a.checkpoint");
    write_checkpoint(path, sample());
    EXPECT_REFUSED(read_checkpoint(path, 8), path.string(), "another mesh");
}

TEST(Checkpoint, ThatIsDamagedAnywhereIsRefused) {
    const TemporaryFolder folder;
    const auto path = folder.path("a.checkpoint");
    Checkpoint small = sample();
    small.state.erase(small.state.begin());
    write_checkpoint(path, small);
    const std::string text = read_text(path);
    for (std::size_t i = 0; i < text.size(); ++i) {
        write_bytes(path, text.substr(0, i));
        EXPECT_NE(error_of([&] { read_checkpoint(path, 7); }), "") << "cut at " << i;
        std::string changed = text;
        changed[i] = static_cast<char>(changed[i] ^ 16);
        write_bytes(path, changed);
        EXPECT_NE(error_of([&] { read_checkpoint(path, 7); }), "") << "changed at " << i;
    }
    write_bytes(path, text);
    EXPECT_EQ(error_of([&] { read_checkpoint(path, 7); }), "");
}

} // namespace polydec::test::in_checkpoint
