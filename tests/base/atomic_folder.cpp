// SPDX-License-Identifier: MIT
#include "system/atomic_folder.h"

#include "tests/io/support.h"

namespace polydec::test::in_atomic_folder {

using Names = std::vector<std::string>;

bool is_ours(std::string_view name) {
    return name == "a.txt" || name == "b.txt";
}

void write(const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path) << text;
}

/// Makes a folder with one file.
void make(const std::filesystem::path& target, const std::string& name, const std::string& text) {
    AtomicFolder folder(target, is_ours);
    write(folder.path() / name, text);
    folder.commit();
}

TEST(AtomicFolder, AppearsWholeWithItsCommit) {
    const TemporaryFolder place;
    const auto target = place.path("out");
    AtomicFolder folder(target, is_ours);
    write(folder.path() / "a.txt", "a");
    EXPECT_FALSE(std::filesystem::exists(target));
    folder.commit();
    EXPECT_EQ(place.names(), Names{"out"});
    EXPECT_EQ(read_text(target / "a.txt"), "a");
}

TEST(AtomicFolder, LeavesNothingWithoutCommit) {
    const TemporaryFolder place;
    {
        AtomicFolder folder(place.path("x/y/out"), is_ours);
        write(folder.path() / "a.txt", "a");
    }
    EXPECT_EQ(place.names(), Names{});
}

TEST(AtomicFolder, ReplacesAnEarlierResultAndNothingElse) {
    const TemporaryFolder place;
    const auto target = place.path("out");
    make(target, "a.txt", "old");
    make(target, "b.txt", "new");
    EXPECT_FALSE(std::filesystem::exists(target / "a.txt"));
    EXPECT_EQ(read_text(target / "b.txt"), "new");
    EXPECT_EQ(place.names(), Names{"out"});

    write(target / "mine.txt", "precious");
    EXPECT_REFUSED(AtomicFolder(target, is_ours), target.string(), "mine.txt");
    EXPECT_EQ(read_text(target / "b.txt"), "new");
}

TEST(AtomicFolder, LooksAgainBeforeItReplaces) {
    const TemporaryFolder place;
    const auto target = place.path("out");
    make(target, "a.txt", "old");
    {
        AtomicFolder folder(target, is_ours);
        write(target / "mine.txt", "precious");
        EXPECT_NE(error_of([&] { folder.commit(); }), "");
    }
    EXPECT_EQ(read_text(target / "mine.txt"), "precious");
    EXPECT_EQ(read_text(target / "a.txt"), "old");
    EXPECT_EQ(place.names(), Names{"out"});
}

TEST(AtomicFolder, MakesTheFoldersOnTheWay) {
    const TemporaryFolder place;
    make(place.path("x/y/out"), "a.txt", "a");
    EXPECT_EQ(read_text(place.path("x/y/out/a.txt")), "a");
    EXPECT_EQ(place.names(), Names{"x"});
}

TEST(AtomicFolder, IsRemovedWithWhatElseIsUnfinished) {
    const TemporaryFolder place;
    make(place.path("out"), "a.txt", "old");
    AtomicFolder folder(place.path("out"), is_ours);
    write(folder.path() / "b.txt", "new");
    remove_unfinished();
    EXPECT_EQ(place.names(), Names{"out"});
    EXPECT_EQ(read_text(place.path("out/a.txt")), "old");
}

} // namespace polydec::test::in_atomic_folder
