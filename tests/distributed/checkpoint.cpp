// SPDX-License-Identifier: MIT
#include "distributed/checkpoint.h"

#include "tests/distributed/common_folder.h"
#include "tests/distributed/compare.h"
#include "tests/io/support.h"

namespace polydec::test::in_checkpoint {

/// A number that tells of which cell it is, to the last bit.
double value_of(int degree, GlobalIndex number) {
    return std::sin(1.0 + 10 * degree + static_cast<double>(number));
}

SharedCheckpoint state_of(const DistributedCells& cells) {
    SharedCheckpoint checkpoint{{.problem = 7, .step = 12, .time = 0.3}, {0, 1, 1}};
    for (const int k : checkpoint.degrees) {
        const auto& numbers = cells.degree(k).number;
        Vector& own = checkpoint.own.state.emplace_back(std::ssize(numbers));
        for (Index i = 0; i < own.size(); ++i)
            own[i] = value_of(k, numbers[static_cast<std::size_t>(i)]);
    }
    return checkpoint;
}

TEST(SharedCheckpoints, have_the_bytes_of_one_process_and_come_back_on_any_ranks) {
    const auto ranks = Ranks::all();
    const CommonFolder folder(ranks);
    for (const auto& [name, given] : meshes()) {
        const auto cells = discretized(ranks, given, some_ownerships(ranks, name).back()).cells;
        const SharedCheckpoint saved = state_of(cells);
        write_checkpoint(ranks, folder / "shared", cells, saved);
        on_rank_0(ranks, [&] {
            Checkpoint one{.problem = 7, .step = 12, .time = 0.3};
            for (const int k : saved.degrees) {
                Vector& all = one.state.emplace_back(cells.degree(k).count);
                for (Index i = 0; i < all.size(); ++i)
                    all[i] = value_of(k, i);
            }
            write_checkpoint(folder / "one", one);
            EXPECT_TRUE(read_text(folder / "shared") == read_text(folder / "one"));
        });
        const auto back = read_checkpoint(ranks, folder / "one", cells, 7, saved.degrees);
        EXPECT_EQ(back.own.step, 12U);
        EXPECT_EQ(back.own.time, 0.3);
        for (std::size_t i = 0; i < saved.degrees.size(); ++i)
            EXPECT_EQ(back.own.state[i], saved.own.state[i]) << name;
    }
}

TEST(SharedCheckpoints, of_others_or_damaged_are_refused_everywhere) {
    const auto ranks = Ranks::all();
    const CommonFolder folder(ranks);
    const auto cells = discretized(ranks, mesh_named("grid4"), Ownership::morton).cells;
    write_checkpoint(ranks, folder / "a", cells, state_of(cells));
    EXPECT_THROW(read_checkpoint(ranks, folder / "a", cells, 8, {0, 1, 1}), InvalidInput);
    EXPECT_THROW(read_checkpoint(ranks, folder / "a", cells, 7, {0, 1}), InvalidInput);
    EXPECT_THROW(read_checkpoint(ranks, folder / "a", cells, 7, {0, 1, 2}), InvalidInput);
    EXPECT_THROW(read_checkpoint(ranks, folder / "none", cells, 7, {0}), IoError);
    on_rank_0(ranks, [&] {
        std::string text = read_text(folder / "a");
        text[text.size() / 2] = static_cast<char>(text[text.size() / 2] ^ 1);
        std::ofstream(folder / "b", std::ios::binary) << text;
    });
    EXPECT_THROW(read_checkpoint(ranks, folder / "b", cells, 7, {0, 1, 1}), InvalidInput);
    EXPECT_THROW(write_checkpoint(ranks, folder / "no" / "file", cells, state_of(cells)), IoError);
    SharedCheckpoint wrong = state_of(cells);
    wrong.own.state.pop_back();
    EXPECT_THROW(write_checkpoint(ranks, folder / "c", cells, wrong), InvalidInput);
    EXPECT_FALSE(std::filesystem::exists(folder / "c"));
}

} // namespace polydec::test::in_checkpoint
